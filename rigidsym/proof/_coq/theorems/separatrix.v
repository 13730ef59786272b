(* The motion on the separatrix: the theorem on bodies with three different moments, with functions that
   Coq has. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Rigidsym.theorems Require Import motion pull_back asymmetric.
Open Scope R_scope.

Definition sech (u : R) : R := / cosh u.
Definition atanh (x : R) : R := ln ((1 + x) / (1 - x)) / 2.

Lemma cosh_positive u : 0 < cosh u.
Proof. unfold cosh; pose proof (exp_pos u); pose proof (exp_pos (- u)); lra. Qed.
Lemma cosh_sinh u : cosh u ^ 2 = 1 + sinh u ^ 2.
Proof.
  unfold cosh, sinh; pose proof (exp_pos u); rewrite exp_Ropp; field; lra.
Qed.
Lemma derive_cosh u : is_derive cosh u (sinh u).
Proof. apply is_derive_Reals, derivable_pt_lim_cosh. Qed.
Lemma derive_sinh u : is_derive sinh u (cosh u).
Proof. apply is_derive_Reals, derivable_pt_lim_sinh. Qed.

Lemma derive_tanh u : is_derive tanh u (sech u * sech u).
Proof.
  pose proof (derive_cosh u); pose proof (derive_sinh u); pose proof (cosh_positive u).
  unfold tanh, sech; derive_known; [lra|].
  transitivity ((cosh u ^ 2 - sinh u ^ 2) / cosh u ^ 2); [field | rewrite cosh_sinh at 1; field]; lra.
Qed.
Lemma derive_sech u : is_derive sech u (- tanh u * sech u).
Proof.
  pose proof (derive_cosh u); pose proof (cosh_positive u).
  unfold tanh, sech; derive_known; [lra|]; field; lra.
Qed.
Lemma jacobi_at_1 : jacobi 1 tanh sech sech.
Proof.
  constructor; intros.
  - apply derive_tanh.
  - apply derive_sech.
  - refine (derive_as _ _ _ _ (derive_sech u) _); ring.
  - unfold tanh; rewrite sinh_0; unfold Rdiv; ring.
  - unfold sech; rewrite cosh_0; apply Rinv_1.
  - unfold sech; rewrite cosh_0; apply Rinv_1.
Qed.

Lemma tanh_atanh x : -1 < x < 1 -> tanh (atanh x) = x.
Proof.
  intros X; unfold tanh, sinh, cosh, atanh; set (u := ln _ / 2).
  assert (E : exp u * exp u = (1 + x) / (1 - x)).
  { rewrite <- exp_plus; replace (u + u) with (ln ((1 + x) / (1 - x))) by (unfold u; field).
    apply exp_ln, Rdiv_lt_0_compat; lra. }
  pose proof (exp_pos u) as P; rewrite exp_Ropp.
  replace ((exp u - / exp u) / 2 / ((exp u + / exp u) / 2))
    with ((exp u * exp u - 1) / (exp u * exp u + 1)) by (field; nra).
  rewrite E; field; lra.
Qed.

Lemma sech_positive u : 0 < sech u.
Proof. apply Rinv_0_lt_compat, cosh_positive. Qed.

(* Half the argument. *)
Lemma cosh_half u : cosh (u / 2) ^ 2 = (cosh u + 1) / 2.
Proof.
  unfold cosh; replace u with (u / 2 + u / 2) at 3 4 by field; rewrite Ropp_plus_distr, !exp_plus, exp_Ropp.
  pose proof (exp_pos (u / 2)); field; lra.
Qed.
Lemma sinh_half u : sinh (u / 2) ^ 2 = (cosh u - 1) / 2.
Proof. pose proof (cosh_half u); pose proof (cosh_sinh (u / 2)); lra. Qed.

Lemma derive_half_turn (r lambda u_0 t : R) :
  is_derive (fun t => atan (r * tanh ((lambda * t + u_0) / 2))) t
    (r * lambda / ((1 + r ^ 2) * cosh (lambda * t + u_0) + (1 - r ^ 2))).
Proof.
  set (u := lambda * t + u_0).
  assert (D : is_derive (fun t => r * tanh ((lambda * t + u_0) / 2)) t
    (r * (lambda / 2 * (sech (u / 2) * sech (u / 2))))).
  { apply (is_derive_scal (fun t => tanh ((lambda * t + u_0) / 2)) t r).
    apply (is_derive_comp tanh (fun t => (lambda * t + u_0) / 2));
      [apply derive_tanh | auto_derive; [easy | field]]. }
  refine (derive_as _ _ _ _ (is_derive_comp atan _ t _ _ (is_derive_atan _) D) _).
  unfold scal; cbn -[pow]; unfold mult; cbn -[pow]; fold u; unfold tanh, sech.
  pose proof (cosh_positive (u / 2)) as C; pose proof (cosh_positive u) as P.
  pose proof (pow2_ge_0 (r * sinh (u / 2))) as S; pose proof (pow_lt _ 2 C) as C2.
  replace ((1 + r ^ 2) * cosh u + (1 - r ^ 2)) with
    (2 * (cosh (u / 2) ^ 2 + (r * sinh (u / 2)) ^ 2)) by (rewrite Rpow_mult_distr, cosh_half, sinh_half; field).
  unfold Rsqr; field; repeat split; nra.
Qed.

Lemma root_of x : 0 < x -> 0 < sqrt x /\ sqrt x ^ 2 = x.
Proof. intros X; split; [now apply sqrt_lt_R0 | now apply pow2_sqrt, Rlt_le]. Qed.

Section Separatrix.
  Variables (h rho sigma chi c_a c_b c_d v_a v_b v_d : R).
  Hypothesis C : circulates h rho sigma chi c_a c_b c_d v_a v_b v_d.
  Let tau := - rho * h * sigma.
  Hypothesis separates : c_a * (c_a - c_b) * v_a ^ 2 = c_d * (c_b - c_d) * v_d ^ 2.
  Hypotheses (Sa : 0 < sigma * v_a) (Sd : 0 < chi * tau * v_d).
  Let E_a := c_b * (c_a - c_b) * v_b ^ 2 + c_d * (c_a - c_d) * v_d ^ 2.
  Let E_d := c_a * (c_a - c_d) * v_a ^ 2 + c_b * (c_b - c_d) * v_b ^ 2.
  Let A_a := sqrt (E_d / (c_a * (c_a - c_d))).
  Let A_b := sqrt (E_a / (c_b * (c_a - c_b))).
  Let A_d := sqrt (E_a / (c_d * (c_a - c_d))).
  Let lambda := sqrt ((c_a - c_b) * E_d / (c_a * c_b * c_d)).
  Let K := sqrt ((c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2).
  Let x := chi * v_b / A_b.

  Let roots := under_roots _ _ _ _ _ _ _ _ _ _ C.
  Lemma Aa : 0 < A_a /\ A_a ^ 2 = E_d / (c_a * (c_a - c_d)).
  Proof. apply root_of, roots. Qed.
  Lemma Ab : 0 < A_b /\ A_b ^ 2 = E_a / (c_b * (c_a - c_b)).
  Proof. apply root_of, roots. Qed.
  Lemma Ad : 0 < A_d /\ A_d ^ 2 = E_a / (c_d * (c_a - c_d)).
  Proof. apply root_of, roots. Qed.
  Lemma La : 0 < lambda /\ lambda ^ 2 = (c_a - c_b) * E_d / (c_a * c_b * c_d).
  Proof. apply root_of, roots. Qed.
  Lemma Kp : 0 < K /\ K ^ 2 = (c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2.
  Proof. apply root_of, roots. Qed.

  Lemma nonzero : (0 < c_a /\ 0 < c_b /\ 0 < c_d) /\
    c_a - c_b <> 0 /\ c_b - c_d <> 0 /\ c_a - c_d <> 0 /\ E_a <> 0 /\ E_d <> 0.
  Proof.
    destruct roots as ((Ea & Ed) & _); pose proof C as [Hand Rho Sigma Chi Ca Cb Cd Rab Rbd _ _].
    fold E_a in Ea; fold E_d in Ed; repeat split; trivial; intros Z;
      [rewrite Z in Rab | rewrite Z in Rbd | assert (ad : 0 < rho * (c_a - c_d)) by lra; rewrite Z in ad
      | rewrite Z in Ea | rewrite Z in Ed]; lra.
  Qed.

  Lemma ratio_of_energies : E_a * (c_b - c_d) = E_d * (c_a - c_b).
  Proof.
    apply Rminus_diag_uniq; transitivity ((c_a - c_d) *
      (c_d * (c_b - c_d) * v_d ^ 2 - c_a * (c_a - c_b) * v_a ^ 2)); [unfold E_a, E_d; ring|].
    rewrite separates; ring.
  Qed.

  Lemma modulus : E_a * (c_b - c_d) / (E_d * (c_a - c_b)) = 1.
  Proof. destruct nonzero as (_ & ? & ? & ? & ? & ?); rewrite ratio_of_energies; field; auto. Qed.

  Lemma gap : 1 - x ^ 2 = c_d * (c_a - c_d) * v_d ^ 2 / E_a.
  Proof.
    destruct nonzero as ((? & ? & ?) & ? & ? & ? & ? & ?), Ab as (? & A2).
    pose proof C as [Hand Rho Sigma Chi Ca Cb Cd Rab Rbd _ _].
    transitivity (1 - v_b ^ 2 / A_b ^ 2); [unfold x; field_simplify; [rewrite Chi; field | |]; lra|].
    rewrite A2; replace (c_d * (c_a - c_d) * v_d ^ 2) with (E_a - c_b * (c_a - c_b) * v_b ^ 2)
      by (unfold E_a; ring).
    field; repeat split; lra.
  Qed.

  Lemma x_bounded : -1 < x < 1.
  Proof.
    assert (G : 0 < 1 - x ^ 2).
    { rewrite gap; destruct roots as ((Ea & _) & _); fold E_a in Ea.
      pose proof C as [Hand Rho Sigma Chi Ca Cb Cd Rab Rbd _ _].
      assert (V : v_d <> 0) by (intros Z; rewrite Z in Sd; lra).
      replace (_ / E_a) with (c_d * (rho * (c_a - c_d)) * v_d ^ 2 / (rho * E_a))
        by (field; split; intros Z; rewrite Z in Ea; lra).
      apply Rdiv_lt_0_compat; [|exact Ea].
      apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra | now apply pow2_gt_0]. }
    clear - G; nra.
  Qed.

  Lemma sech_at_start : sech (atanh x) ^ 2 = 1 - x ^ 2.
  Proof.
    rewrite <- (tanh_atanh x x_bounded) at 2; set (u := atanh x); unfold sech, tanh.
    pose proof (cosh_positive u).
    transitivity ((cosh u ^ 2 - sinh u ^ 2) / cosh u ^ 2); [rewrite cosh_sinh at 1 |]; field; lra.
  Qed.

  Lemma start_a : sigma * A_a * sech (atanh x) = v_a.
  Proof.
    destruct nonzero as ((? & ? & ?) & ? & ? & ? & ? & ?), Aa as (? & A2).
    pose proof C as [Hand Rho Sigma Chi Ca Cb Cd Rab Rbd _ _]; pose proof (sech_positive (atanh x)).
    assert (E : A_a * sech (atanh x) = sigma * v_a).
    { apply root_unique; [now apply Rmult_lt_0_compat | exact Sa |].
      rewrite !Rpow_mult_distr, sech_at_start, A2, gap, Sigma.
      replace (v_a ^ 2) with (c_d * (c_b - c_d) * v_d ^ 2 / (c_a * (c_a - c_b)))
        by (rewrite <- separates; field; lra).
      replace E_d with (E_a * (c_b - c_d) / (c_a - c_b)) by (rewrite ratio_of_energies; field; lra).
      field; repeat split; lra. }
    rewrite Rmult_assoc, E; ring [Sigma].
  Qed.

  Lemma start_d : chi * tau * A_d * sech (atanh x) = v_d.
  Proof.
    destruct nonzero as ((? & ? & ?) & ? & ? & ? & ? & ?), Ad as (? & A2).
    pose proof C as [Hand Rho Sigma Chi Ca Cb Cd Rab Rbd _ _]; pose proof (sech_positive (atanh x)).
    assert (T : (chi * tau) ^ 2 = 1) by (unfold tau; ring [Hand Rho Sigma Chi]).
    assert (E : A_d * sech (atanh x) = chi * tau * v_d).
    { apply root_unique; [now apply Rmult_lt_0_compat | exact Sd |].
      rewrite Rpow_mult_distr, sech_at_start, A2, gap, (Rpow_mult_distr _ v_d), T.
      field; repeat split; lra. }
    rewrite Rmult_assoc, E; transitivity ((chi * tau) ^ 2 * v_d); [ring | rewrite T; ring].
  Qed.

  Lemma start_b : chi * A_b * tanh (atanh x) = v_b.
  Proof.
    rewrite tanh_atanh by exact x_bounded; destruct Ab; unfold x.
    pose proof C as [Hand Rho Sigma Chi Ca Cb Cd Rab Rbd _ _].
    transitivity (chi ^ 2 * v_b); [field; lra | rewrite Chi; ring].
  Qed.

  (* The angle psi. *)
  Lemma energy_of_momentum : 2 * energy c_a c_b c_d v_a v_b v_d = K ^ 2 / c_b.
  Proof.
    destruct nonzero as ((? & ? & ?) & _), Kp as (_ & ->); unfold energy.
    apply Rminus_diag_uniq; transitivity ((c_d * (c_b - c_d) * v_d ^ 2 - c_a * (c_a - c_b) * v_a ^ 2) / c_b);
      [field; lra | rewrite separates; field; lra].
  Qed.

  Lemma momentum_of_amplitudes : K ^ 2 = (c_a * A_a) ^ 2 + (c_d * A_d) ^ 2.
  Proof.
    destruct nonzero as ((? & ? & ?) & ? & ? & ? & ? & ?), Kp as (_ & ->), Aa as (_ & A2), Ad as (_ & D2).
    rewrite !(Rpow_mult_distr _ A_a), !(Rpow_mult_distr _ A_d), A2, D2; unfold E_a, E_d.
    field; repeat split; lra.
  Qed.

  Lemma momentum_b : K ^ 2 = c_b * E_a / (c_a - c_b).
  Proof.
    destruct nonzero as ((? & ? & ?) & ? & ? & ? & ? & ?), Kp as (_ & ->).
    apply Rminus_diag_uniq; transitivity (c_a / (c_a - c_b) *
      (c_a * (c_a - c_b) * v_a ^ 2 - c_d * (c_b - c_d) * v_d ^ 2)); [unfold E_a; field; lra|].
    rewrite separates; ring.
  Qed.

  Lemma turning_rate : rho * lambda * (c_d * A_d) = K * (c_a * A_a) * (1 / c_b - 1 / c_a).
  Proof.
    destruct nonzero as ((? & ? & ?) & ? & ? & ? & ? & ?), Kp as (? & _), Aa as (? & A2), Ad as (? & D2),
      La as (? & L2); pose proof C as [Hand Rho Sigma Chi Ca Cb Cd Rab Rbd _ _].
    assert (E : lambda * (c_d * A_d) = K * (c_a * A_a) * (rho * (c_a - c_b) / (c_a * c_b))).
    { apply root_unique.
      - repeat (assumption || apply Rmult_lt_0_compat).
      - repeat (assumption || apply Rdiv_lt_0_compat || apply Rmult_lt_0_compat).
      - transitivity (lambda ^ 2 * c_d ^ 2 * A_d ^ 2); [ring|].
        transitivity (K ^ 2 * c_a ^ 2 * A_a ^ 2 * rho ^ 2 * ((c_a - c_b) / (c_a * c_b)) ^ 2);
          [|field; lra].
        rewrite L2, D2, A2, momentum_b, Rho; field; repeat split; lra. }
    rewrite Rmult_assoc, E; transitivity (K * (c_a * A_a) * (rho ^ 2 * (c_a - c_b) / (c_a * c_b)));
      [field; lra | rewrite Rho; field; lra].
  Qed.

  Lemma angle_rate c : 0 < c -> let r := c_d * A_d / (K + c_a * A_a) in
    K / c_b - 2 * rho * (r * lambda / ((1 + r ^ 2) * c + (1 - r ^ 2))) =
    (2 * energy c_a c_b c_d v_a v_b v_d + K * (A_a * / c)) / (K + c_a * (A_a * / c)).
  Proof.
    intros P r; destruct nonzero as ((? & ? & ?) & _), Kp as (? & _), Aa as (? & _), Ad as (? & _).
    assert (Ba : 0 < c_a * A_a) by now apply Rmult_lt_0_compat.
    assert (Kc : 0 < K * c) by now apply Rmult_lt_0_compat.
    assert (R2 : r ^ 2 = (K - c_a * A_a) / (K + c_a * A_a)).
    { transitivity ((c_d * A_d) ^ 2 / (K + c_a * A_a) ^ 2); [unfold r; field; lra|].
      replace ((c_d * A_d) ^ 2) with (K ^ 2 - (c_a * A_a) ^ 2) by (rewrite momentum_of_amplitudes; ring).
      field; lra. }
    rewrite R2, energy_of_momentum.
    transitivity (K / c_b - rho * lambda * (c_d * A_d) / (K * c + c_a * A_a));
      [unfold r | rewrite turning_rate]; field; repeat split; lra.
  Qed.
End Separatrix.

Theorem separatrix_motion (h rho sigma chi c_a c_b c_d v_a v_b v_d : R) (p : quaternion) :
  circulates h rho sigma chi c_a c_b c_d v_a v_b v_d -> norm_squared p = 1 ->
  let tau := - rho * h * sigma in
  (* It is on the separatrix, sigma is the side of v_a, and chi tau that of v_d. *)
  c_a * (c_a - c_b) * v_a ^ 2 = c_d * (c_b - c_d) * v_d ^ 2 -> 0 < sigma * v_a -> 0 < chi * tau * v_d ->
  let E_a := c_b * (c_a - c_b) * v_b ^ 2 + c_d * (c_a - c_d) * v_d ^ 2 in
  let E_d := c_a * (c_a - c_d) * v_a ^ 2 + c_b * (c_b - c_d) * v_b ^ 2 in
  let A_a := sqrt (E_d / (c_a * (c_a - c_d))) in
  let A_b := sqrt (E_a / (c_b * (c_a - c_b))) in
  let A_d := sqrt (E_a / (c_d * (c_a - c_d))) in
  let lambda := sqrt ((c_a - c_b) * E_d / (c_a * c_b * c_d)) in
  let u t := lambda * t + atanh (chi * v_b / A_b) in
  let w_a t := sigma * A_a / cosh (u t) in
  let w_b t := chi * A_b * tanh (u t) in
  let w_d t := chi * tau * A_d / cosh (u t) in
  let K := sqrt ((c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2) in
  let half_turn t := atan (c_d * A_d / (K + c_a * A_a) * tanh (u t / 2)) in
  let psi t := K / c_b * t - 2 * rho * (half_turn t - half_turn 0) in
  the_motion h c_a c_b c_d v_a v_b v_d p w_a w_b w_d (from_start h p (fun t =>
    pulled_back h sigma K (c_a * w_a t) (c_b * w_b t) (c_d * w_d t) (psi t))).
Proof.
  intros C P tau Sep Sa Sd E_a E_d A_a A_b A_d lambda u w_a w_b w_d K half_turn psi.
  assert (J : jacobi (E_a * (c_b - c_d) / (E_d * (c_a - c_b))) tanh sech sech)
    by (unfold E_a, E_d; rewrite (modulus _ _ _ _ _ _ _ _ _ _ C Sep); exact jacobi_at_1).
  assert (S : sigma * A_a * sech (u 0) = v_a /\ chi * A_b * tanh (u 0) = v_b /\
    chi * tau * A_d * sech (u 0) = v_d).
  { unfold u; rewrite Rmult_0_r, Rplus_0_l; split; [|split];
      [eapply start_a | eapply start_b | eapply start_d]; eassumption. }
  unfold u in S at 1 2 3; rewrite Rmult_0_r, Rplus_0_l in S; destruct S as (S1 & S2 & S3).
  destruct (asymmetric_motion h rho sigma chi c_a c_b c_d v_a v_b v_d p C P tanh sech sech _ J S1 S2 S3)
    as [_ T].
  apply T; intros t; clear T.
  pose proof (derive_half_turn (c_d * A_d / (K + c_a * A_a)) lambda (atanh (chi * v_b / A_b)) t
    : is_derive half_turn t _) as D; clearbody half_turn.
  match type of D with is_derive _ _ ?l => refine (derive_as psi t (K / c_b - 2 * rho * l) _ _ _) end;
    [unfold psi; derive_known; ring|].
  pose proof (cosh_positive (u t)) as Q; unfold u in Q.
  etransitivity; [eapply angle_rate; eassumption|].
  fold E_a E_d; fold A_a K lambda; unfold sech; destruct C as [_ _ Sigma _ _ _ _ _ _ _ _].
  apply (f_equal2 Rdiv); ring [Sigma].
Qed.
