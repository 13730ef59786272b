(* The motion of a body with three different moments, by Jacobi's functions: what the contexts `regular`
   and `attitude` of the ledger prove.

   Coq has no Jacobi functions.  That sn, cn, dn have their derivatives and their start is supposed, and
   nothing else of them; on the separatrix, where m = 1, they are tanh, 1/cosh, 1/cosh. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Rigidsym.theorems Require Import motion pull_back.
From Rigidsym.contexts Require regular.
Open Scope R_scope.

Record jacobi (m : R) (sn cn dn : R -> R) : Prop := Jacobi {
  derivative_sn : forall u, is_derive sn u (cn u * dn u);
  derivative_cn : forall u, is_derive cn u (- sn u * dn u);
  derivative_dn : forall u, is_derive dn u (- m * sn u * cn u);
  sn_0 : sn 0 = 0;
  cn_0 : cn 0 = 1;
  dn_0 : dn 0 = 1
}.

Lemma sn_cn m sn cn dn : jacobi m sn cn dn -> forall u, sn u ^ 2 + cn u ^ 2 = 1.
Proof.
  intros J u; transitivity (sn 0 ^ 2 + cn 0 ^ 2);
    [|rewrite (sn_0 _ _ _ _ J), (cn_0 _ _ _ _ J); ring].
  apply (constant_in_time (fun u => sn u ^ 2 + cn u ^ 2)); intros x; destruct J as [S C D _ _ _].
  specialize (S x); specialize (C x); derive_known; ring.
Qed.
Lemma sn_dn m sn cn dn : jacobi m sn cn dn -> forall u, m * sn u ^ 2 + dn u ^ 2 = 1.
Proof.
  intros J u; transitivity (m * sn 0 ^ 2 + dn 0 ^ 2);
    [|rewrite (sn_0 _ _ _ _ J), (dn_0 _ _ _ _ J); ring].
  apply (constant_in_time (fun u => m * sn u ^ 2 + dn u ^ 2)); intros x; destruct J as [S C D _ _ _].
  specialize (S x); specialize (D x); derive_known; ring.
Qed.

Lemma weighted x y a b : 0 < x -> 0 < y -> 0 < a ^ 2 + b ^ 2 -> 0 < x * a ^ 2 + y * b ^ 2.
Proof.
  intros X Y S; pose proof (pow2_ge_0 a) as A; pose proof (pow2_ge_0 b) as B.
  destruct (Rle_lt_or_eq_dec _ _ A) as [A'|A']; nra.
Qed.

Lemma root_unique x y : 0 < x -> 0 < y -> x ^ 2 = y ^ 2 -> x = y.
Proof. intros X Y E; apply Rsqr_inj; [lra | lra | rewrite !Rsqr_pow2; exact E]. Qed.

Section Rates.
  Variables (h rho sigma chi c_a c_b c_d A_a A_b A_d lambda m E_a E_d u_0 : R) (sn cn dn : R -> R).
  Hypotheses (H : h ^ 2 = 1) (Rho : rho ^ 2 = 1) (Sigma : sigma ^ 2 = 1) (Chi : chi ^ 2 = 1).
  Hypotheses (Ca : 0 < c_a) (Cb : 0 < c_b) (Cd : 0 < c_d).
  Hypotheses (ab : 0 < rho * (c_a - c_b)) (bd : 0 < rho * (c_b - c_d)) .
  Hypotheses (Ea : 0 < rho * E_a) (Ed : 0 < rho * E_d).
  Hypotheses (Aa : 0 < A_a) (Ab : 0 < A_b) (Ad : 0 < A_d) (L : 0 < lambda).
  Hypotheses (Aa2 : A_a ^ 2 = E_d / (c_a * (c_a - c_d))) (Ab2 : A_b ^ 2 = E_a / (c_b * (c_a - c_b)))
    (Ad2 : A_d ^ 2 = E_a / (c_d * (c_a - c_d))) (L2 : lambda ^ 2 = (c_a - c_b) * E_d / (c_a * c_b * c_d))
    (M : m = E_a * (c_b - c_d) / (E_d * (c_a - c_b))) (J : jacobi m sn cn dn).

  Let Delta := rho * (1 / c_d - 1 / c_a).
  Let B_a := c_a * A_a.
  Let B_b := c_b * A_b.
  Let B_d := c_d * A_d.
  Let at_phase (f : R -> R) t := f (lambda * t + u_0).
  Let X := regular.name h sigma rho chi (1 / c_a) Delta B_a B_d m B_b
    (at_phase sn) (at_phase cn) (at_phase dn).

  Let tau := - rho * h * sigma.
  Let w_a t := sigma * A_a * dn (lambda * t + u_0).
  Let w_b t := chi * A_b * sn (lambda * t + u_0).
  Let w_d t := chi * tau * A_d * cn (lambda * t + u_0).

  Lemma nonzero_differences :
    c_a - c_b <> 0 /\ c_b - c_d <> 0 /\ c_a - c_d <> 0 /\ E_a <> 0 /\ E_d <> 0.
  Proof.
    repeat split; intros Z;
      [rewrite Z in ab | rewrite Z in bd | assert (ad : 0 < rho * (c_a - c_d)) by lra; rewrite Z in ad
      | rewrite Z in Ea | rewrite Z in Ed]; lra.
  Qed.

  Lemma inverse_b : 1 / c_a + rho * Delta * B_d ^ 2 / B_b ^ 2 = 1 / c_b.
  Proof.
    destruct nonzero_differences as (? & ? & ? & ? & ?).
    unfold Delta, B_d, B_b; rewrite !Rpow_mult_distr, Ad2, Ab2.
    replace (rho * (rho * (1 / c_d - 1 / c_a))) with (1 / c_d - 1 / c_a) by ring [Rho].
    field; repeat split; lra.
  Qed.

  Lemma squares : B_b ^ 2 = B_d ^ 2 + m * B_a ^ 2.
  Proof.
    destruct nonzero_differences as (? & ? & ? & ? & ?).
    unfold B_a, B_d, B_b; rewrite !Rpow_mult_distr, Aa2, Ad2, Ab2, M; field; repeat split; lra.
  Qed.

  Lemma Delta_positive : 0 < Delta.
  Proof.
    unfold Delta; replace (rho * _) with (rho * (c_a - c_d) / (c_a * c_d)) by (field; lra).
    apply Rdiv_lt_0_compat; [lra | now apply Rmult_lt_0_compat].
  Qed.

  Lemma rate : Delta * B_a * B_d / B_b = lambda.
  Proof.
    destruct nonzero_differences as (? & ? & ? & ? & ?); pose proof Delta_positive.
    assert (Q : 0 < Delta * B_a * B_d / B_b)
      by (apply Rdiv_lt_0_compat; unfold B_a, B_b, B_d; repeat (assumption || apply Rmult_lt_0_compat)).
    apply root_unique; [exact Q | exact L |].
    transitivity (Delta ^ 2 * B_a ^ 2 * B_d ^ 2 / B_b ^ 2);
      [field; now apply Rgt_not_eq, Rmult_lt_0_compat|].
    unfold Delta, B_a, B_b, B_d; rewrite !Rpow_mult_distr, Aa2, Ab2, Ad2, L2, Rho; field; repeat split; lra.
  Qed.

  Lemma derive_at_phase (f df : R -> R) t : (forall u, is_derive f u (df u)) ->
    is_derive (at_phase f) t (lambda * df (lambda * t + u_0)).
  Proof.
    intros D; apply (is_derive_comp f (fun t => lambda * t + u_0)); [apply D | auto_derive; [easy | ring]].
  Qed.

  Lemma inverse_d : 1 / c_a + rho * Delta = 1 / c_d.
  Proof.
    unfold Delta; replace (rho * (rho * (1 / c_d - 1 / c_a))) with (1 / c_d - 1 / c_a) by ring [Rho]; ring.
  Qed.

  Lemma moment_a : regular.c_a X = c_a.
  Proof. unfold regular.c_a; cbn; field; lra. Qed.
  Lemma moment_b : regular.c_b X = c_b.
  Proof. unfold regular.c_b, regular.i_b; cbn -[pow]; rewrite inverse_b; field; lra. Qed.
  Lemma moment_d : regular.c_d X = c_d.
  Proof. unfold regular.c_d, regular.i_d; cbn; rewrite inverse_d; field; lra. Qed.
  Lemma amplitude_a : regular.A_a X = A_a.
  Proof. unfold regular.A_a; rewrite moment_a; cbn; unfold B_a; field; lra. Qed.
  Lemma amplitude_b : regular.A_b X = A_b.
  Proof. unfold regular.A_b; rewrite moment_b; cbn; unfold B_b; field; lra. Qed.
  Lemma amplitude_d : regular.A_d X = A_d.
  Proof. unfold regular.A_d; rewrite moment_d; cbn; unfold B_d; field; lra. Qed.

  Lemma rates_in_ledger : regular.holds X.
  Proof.
    pose proof Delta_positive; pose proof squares as Sq.
    assert (Ba : 0 < B_a) by now apply Rmult_lt_0_compat.
    assert (Bb : 0 < B_b) by now apply Rmult_lt_0_compat.
    assert (Bd : 0 < B_d) by now apply Rmult_lt_0_compat.
    assert (Bb2 : 0 < B_b ^ 2) by now apply pow_lt.
    assert (inverse : forall c, 0 < c -> 1 / c <> 0)
      by (intros c C; apply Rgt_not_eq, Rdiv_lt_0_compat; lra).
    constructor; rewrite ?amplitude_a, ?amplitude_b, ?amplitude_d; unfold regular.lambda_; cbn -[pow];
      rewrite ?rate; try lra; try (rewrite <- Sq; lra); try (now apply inverse);
      try (intros Z; rewrite Z in ab; lra).
    1-2: match goal with |- ?unit <> 0 => first
      [ replace unit with (1 / c_d) by (rewrite <- inverse_d; ring); now apply inverse
      | replace unit with (B_b ^ 2) by (rewrite Sq; ring); lra
      | replace unit with (B_b ^ 2 * (1 / c_b));
        [apply Rmult_integral_contrapositive_currified; [lra | now apply inverse] |];
        rewrite <- inverse_b; transitivity (B_b ^ 2 / c_a + rho * Delta * B_d ^ 2);
        [field; lra | rewrite Sq; field; lra] ] end.
    - intros t; pose proof (sn_cn m sn cn dn J (lambda * t + u_0)); unfold at_phase; lra.
    - intros t; pose proof (sn_dn m sn cn dn J (lambda * t + u_0)); unfold at_phase; lra.
    - intros t; refine (derive_as _ t _ _ (derive_at_phase _ _ t (derivative_sn _ _ _ _ J)) _).
      unfold at_phase; ring.
    - intros t; refine (derive_as _ t _ _ (derive_at_phase _ _ t (derivative_cn _ _ _ _ J)) _).
      unfold at_phase; ring.
    - intros t; refine (derive_as _ t _ _ (derive_at_phase _ _ t (derivative_dn _ _ _ _ J)) _).
      unfold at_phase; ring.
  Qed.

  Lemma rates_solve : euler h c_a c_b c_d w_a w_b w_d.
  Proof.
    intros t; pose proof (regular.fact_euler X rates_in_ledger t) as E; unfold regular.Omega_a,
      regular.Omega_b, regular.Omega_d in E.
    rewrite moment_a, moment_b, moment_d, amplitude_a, amplitude_b, amplitude_d in E; cbn -[pow] in E.
    change (regular.tau X) with tau in E; unfold w_a, w_b, w_d, at_phase in *; as_euler E.
  Qed.

  (* The momentum never is opposite to sigma e_a. *)
  Lemma never_opposite K t : 0 < K -> K ^ 2 = (c_a * w_a t) ^ 2 + (c_b * w_b t) ^ 2 + (c_d * w_d t) ^ 2 ->
    0 < K + sigma * (c_a * w_a t).
  Proof.
    intros Kp K2; pose proof (sn_cn m sn cn dn J (lambda * t + u_0)) as S.
    pose proof (weighted (B_b ^ 2) (B_d ^ 2) (sn (lambda * t + u_0)) (cn (lambda * t + u_0))) as W.
    assert (T : tau ^ 2 = 1) by (unfold tau; ring [H Rho Sigma]).
    assert (Q : (c_b * w_b t) ^ 2 + (c_d * w_d t) ^ 2 =
      B_b ^ 2 * sn (lambda * t + u_0) ^ 2 + B_d ^ 2 * cn (lambda * t + u_0) ^ 2)
      by (unfold w_b, w_d, B_b, B_d; ring [T Chi]).
    assert (X2 : (sigma * (c_a * w_a t)) ^ 2 = (c_a * w_a t) ^ 2) by ring [Sigma].
    assert (P : 0 < B_b ^ 2 /\ 0 < B_d ^ 2)
      by (split; apply pow_lt; unfold B_b, B_d; now apply Rmult_lt_0_compat).
    assert (Less : (sigma * (c_a * w_a t)) ^ 2 < K ^ 2)
      by (specialize (W (proj1 P) (proj2 P) ltac:(lra)); lra).
    clear - Kp Less; nra.
  Qed.
End Rates.

(* b is the middle axis, and rho the sign of c_a - c_d; sigma and chi choose sides; and the body turns
   about more than one axis. *)
Record circulates (h rho sigma chi c_a c_b c_d v_a v_b v_d : R) : Prop := Circulates {
  hand : h ^ 2 = 1;
  order : rho ^ 2 = 1;
  side : sigma ^ 2 = 1;
  half : chi ^ 2 = 1;
  positive_a : 0 < c_a;
  positive_b : 0 < c_b;
  positive_d : 0 < c_d;
  order_ab : 0 < rho * (c_a - c_b);
  order_bd : 0 < rho * (c_b - c_d);
  moves_ab : 0 < v_a ^ 2 + v_b ^ 2;
  moves_bd : 0 < v_b ^ 2 + v_d ^ 2
}.

(* What the square roots below are taken of. *)
Lemma under_roots h rho sigma chi c_a c_b c_d v_a v_b v_d :
  circulates h rho sigma chi c_a c_b c_d v_a v_b v_d ->
  let E_a := c_b * (c_a - c_b) * v_b ^ 2 + c_d * (c_a - c_d) * v_d ^ 2 in
  let E_d := c_a * (c_a - c_d) * v_a ^ 2 + c_b * (c_b - c_d) * v_b ^ 2 in
  (0 < rho * E_a /\ 0 < rho * E_d) /\
  (0 < E_d / (c_a * (c_a - c_d)) /\ 0 < E_a / (c_b * (c_a - c_b)) /\
   0 < E_a / (c_d * (c_a - c_d)) /\ 0 < (c_a - c_b) * E_d / (c_a * c_b * c_d)) /\
  0 < (c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2.
Proof.
  intros [H Rho Sigma Chi Ca Cb Cd Rab Rbd Vab Vbd] E_a E_d.
  assert (Rad : 0 < rho * (c_a - c_d)) by lra.
  assert (Ea : 0 < rho * E_a).
  { unfold E_a; replace (rho * _) with
      (c_b * (rho * (c_a - c_b)) * v_b ^ 2 + c_d * (rho * (c_a - c_d)) * v_d ^ 2) by ring.
    apply weighted; try apply Rmult_lt_0_compat; assumption. }
  assert (Ed : 0 < rho * E_d).
  { unfold E_d; replace (rho * _) with
      (c_a * (rho * (c_a - c_d)) * v_a ^ 2 + c_b * (rho * (c_b - c_d)) * v_b ^ 2) by ring.
    apply weighted; try apply Rmult_lt_0_compat; assumption. }
  assert (quotient : forall x y z, 0 < rho * x -> 0 < y -> 0 < rho * z -> 0 < x / (y * z)).
  { intros x y z X Y Z; replace (x / (y * z)) with ((rho * x) / (y * (rho * z)))
      by (field; repeat split; intros Q; rewrite Q in *; lra).
    apply Rdiv_lt_0_compat; [exact X | now apply Rmult_lt_0_compat]. }
  repeat split; try assumption; try (now apply quotient).
  - replace (_ * E_d) with (rho * (c_a - c_b) * (rho * E_d)) by ring [Rho].
    apply Rdiv_lt_0_compat; repeat (assumption || apply Rmult_lt_0_compat).
  - rewrite !Rpow_mult_distr.
    pose proof (weighted (c_a ^ 2) (c_b ^ 2) v_a v_b (pow_lt _ 2 Ca) (pow_lt _ 2 Cb) Vab).
    pose proof (pow2_ge_0 (c_d * v_d)) as D; rewrite Rpow_mult_distr in D; lra.
Qed.

Theorem asymmetric_motion (h rho sigma chi c_a c_b c_d v_a v_b v_d : R) (p : quaternion) :
  circulates h rho sigma chi c_a c_b c_d v_a v_b v_d -> norm_squared p = 1 ->
  let E_a := c_b * (c_a - c_b) * v_b ^ 2 + c_d * (c_a - c_d) * v_d ^ 2 in
  let E_d := c_a * (c_a - c_d) * v_a ^ 2 + c_b * (c_b - c_d) * v_b ^ 2 in
  let A_a := sqrt (E_d / (c_a * (c_a - c_d))) in
  let A_b := sqrt (E_a / (c_b * (c_a - c_b))) in
  let A_d := sqrt (E_a / (c_d * (c_a - c_d))) in
  let lambda := sqrt ((c_a - c_b) * E_d / (c_a * c_b * c_d)) in
  let m := E_a * (c_b - c_d) / (E_d * (c_a - c_b)) in
  let tau := - rho * h * sigma in
  forall (sn cn dn : R -> R) (u_0 : R), jacobi m sn cn dn ->
  (* u_0 is the phase of the start. *)
  sigma * A_a * dn u_0 = v_a -> chi * A_b * sn u_0 = v_b -> chi * tau * A_d * cn u_0 = v_d ->
  let w_a t := sigma * A_a * dn (lambda * t + u_0) in
  let w_b t := chi * A_b * sn (lambda * t + u_0) in
  let w_d t := chi * tau * A_d * cn (lambda * t + u_0) in
  let K := sqrt ((c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2) in
  let rate t := (2 * energy c_a c_b c_d v_a v_b v_d + K * sigma * w_a t)
    / (K + sigma * (c_a * w_a t)) in
  (forall t, is_derive (RInt rate 0) t (rate t)) /\
  forall psi, (forall t, is_derive psi t (rate t)) ->
  the_motion h c_a c_b c_d v_a v_b v_d p w_a w_b w_d (from_start h p (fun t =>
    pulled_back h sigma K (c_a * w_a t) (c_b * w_b t) (c_d * w_d t) (psi t))).
Proof.
  intros C P E_a E_d A_a A_b A_d lambda m tau sn cn dn u_0 J Sa Sb Sd w_a w_b w_d K rate.
  destruct (under_roots _ _ _ _ _ _ _ _ _ _ C) as ((Ea & Ed) & (Qa & Qb & Qd & Ql) & Kp).
  destruct C as [H Rho Sigma Chi Ca Cb Cd Rab Rbd Vab Vbd].
  fold E_a E_d in Ea, Ed, Qa, Qb, Qd, Ql.
  pose proof (rates_solve h rho sigma chi c_a c_b c_d A_a A_b A_d lambda m E_a E_d u_0 sn cn dn H Rho Sigma
    Chi Ca Cb Cd Rab Rbd Ea Ed (sqrt_lt_R0 _ Qa) (sqrt_lt_R0 _ Qb) (sqrt_lt_R0 _ Qd) (sqrt_lt_R0 _ Ql)
    (pow2_sqrt _ (Rlt_le _ _ Qa)) (pow2_sqrt _ (Rlt_le _ _ Qb)) (pow2_sqrt _ (Rlt_le _ _ Qd))
    (pow2_sqrt _ (Rlt_le _ _ Ql)) eq_refl J : euler h c_a c_b c_d w_a w_b w_d) as E.
  assert (W : w_a 0 = v_a /\ w_b 0 = v_b /\ w_d 0 = v_d)
    by (unfold w_a, w_b, w_d; rewrite Rmult_0_r, Rplus_0_l; auto).
  destruct W as (Wa & Wb & Wd).
  assert (Side : forall t, 0 < K + sigma * (c_a * w_a t)).
  { intros t; refine (never_opposite h rho sigma chi c_a c_b c_d A_a A_b A_d lambda m u_0 sn cn dn
      H Rho Sigma Chi Cb Cd (sqrt_lt_R0 _ Qb) (sqrt_lt_R0 _ Qd) J K t (sqrt_lt_R0 _ Kp) _).
    change (K ^ 2 = (c_a * w_a t) ^ 2 + (c_b * w_b t) ^ 2 + (c_d * w_d t) ^ 2).
    rewrite (momentum_kept h c_a c_b c_d Ca Cb Cd w_a w_b w_d E t), Wa, Wb, Wd.
    apply pow2_sqrt; lra. }
  split.
  - apply derive_integral; intros x; destruct (E x) as (Da & _ & _); pose proof (Side x).
    unfold rate; auto_derive; repeat split; try (eexists; exact Da); lra.
  - intros psi D; apply pulled_back_motion; try assumption; now apply sqrt_lt_R0.
Qed.
