(* Instances of the published forms: functions of time that satisfy all that contexts of the ledger suppose.

   Jacobi's functions are given by their derivatives and their start, as in `asymmetric`.  They are sin, cos,
     1
   where k = 0, and tanh, 1/cosh, 1/cosh where k = 1: there nothing is supposed. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Rigidsym.theorems Require Import motion pull_back asymmetric separatrix published.
From Rigidsym.contexts Require descended theta_form hyperbolic_form separatrix_form symmetric_form pi_near
  pi_far.
Open Scope R_scope.

Lemma jacobi_at_0 : jacobi 0 sin cos (fun _ => 1).
Proof.
  constructor; intros; trivial using sin_0, cos_0.
  - auto_derive; [easy | ring].
  - auto_derive; [easy | ring].
  - refine (derive_as _ _ _ _ (is_derive_const (K := R_AbsRing) (V := R_NormedModule) 1 u) _).
    unfold zero; cbn; ring.
Qed.

Section Instance.
  Variables (h sigma rho chi i_a Delta B_a B_d k K C_b phase : R) (sn cn dn : R -> R) (start : quaternion).
  Hypotheses (H2 : h ^ 2 = 1) (Sigma : sigma ^ 2 = 1) (Rho : rho ^ 2 = 1) (Chi : chi ^ 2 = 1).
  Hypotheses (Ia : 0 < i_a) (Id : 0 < i_a + rho * Delta) (De : 0 < Delta) (Ba : 0 < B_a) (Bd : 0 < B_d).
  Hypotheses (Kp : 0 <= k <= 1) (Jac : jacobi (k ^ 2) sn cn dn) (Unit : norm_squared start = 1).
  Hypotheses (Kpos : 0 < K) (K2 : K ^ 2 = B_a ^ 2 + B_d ^ 2).
  Hypotheses (Cp : 0 < C_b) (C2 : C_b ^ 2 = (1 + k) ^ 2 * B_d ^ 2 + 4 * k * B_a ^ 2).

  Let mu := Delta * B_a * B_d / (C_b / (1 + k)) / (1 + k).
  Let s t := sn (mu * t + phase).
  Let c t := cn (mu * t + phase).
  Let d t := dn (mu * t + phase).
  Let root t := 2 * K * (K * (1 + k * s t ^ 2) + B_a * (1 - k * s t ^ 2)) * (1 + k * s t ^ 2).
  Let n := k * (B_a - K) / (B_a + K).
  Let J := RInt (fun t => mu * s t ^ 2 / (1 - n * s t ^ 2)) 0.

  (* The names of the ledger, for an angle psi and a factor p in front. *)
  Let names (psi : R -> R) (p : quaternion) : descended.names := {|
    descended.epsilon := h; descended.sigma := sigma; descended.rho := rho; descended.chi := chi;
    descended.i_a := i_a; descended.Delta := Delta; descended.B_a := B_a; descended.B_d := B_d;
    descended.k_1 := k; descended.C_b := C_b; descended.t_ := fun t => t; descended.phase := phase;
    descended.s := s; descended.c := c; descended.d := d; descended.K := K;
    descended.w := fun t => sqrt (root t); descended.J := J; descended.J_0 := 0;
    descended.p_0 := part_0 p; descended.p_a := part_a p; descended.p_b := part_b p;
      descended.p_d := part_d p;
    descended.cos_half_psi := fun t => cos (psi t / 2); descended.sin_half_psi := fun t => sin (psi t / 2) |}.
  Let rate := descended.psi_rate (names (fun _ => 0) start).
  Let psi := RInt rate 0.
  Let qbar := let X := names psi start in
    Quaternion (descended.qbar_0 X 0) (descended.qbar_a X 0) (descended.qbar_b X 0) (descended.qbar_d X 0).
  Definition instance : descended.names := names psi (product h start (conjugate qbar)).

  Lemma size_bounds t : s t ^ 2 <= 1 /\ 0 <= k * s t ^ 2 <= 1.
  Proof.
    pose proof (sn_cn _ _ _ _ Jac (mu * t + phase)) as S; pose proof (pow2_ge_0 (cn (mu * t + phase))).
    assert (A : s t ^ 2 <= 1) by (unfold s; lra); pose proof (pow2_ge_0 (s t)).
    split; [exact A|]; split; [apply Rmult_le_pos; lra|]; nra.
  Qed.

  Lemma K_at_least : B_a <= K.
  Proof. pose proof (pow2_ge_0 B_d); nra. Qed.

  Lemma inside_positive t : 0 < 1 + k * s t ^ 2 /\ 0 < K * (1 + k * s t ^ 2) + B_a * (1 - k * s t ^ 2) /\
    0 < 1 - n * s t ^ 2.
  Proof.
    destruct (size_bounds t) as (A & B); pose proof K_at_least as L.
    assert (N : n <= 0).
    { unfold n; apply Ropp_le_cancel; rewrite Ropp_0.
      replace (- (k * (B_a - K) / (B_a + K))) with (k * (K - B_a) * / (K + B_a)) by (field; lra).
      apply Rmult_le_pos; [apply Rmult_le_pos; lra | left; apply Rinv_0_lt_compat; lra]. }
    repeat split; [lra | | pose proof (pow2_ge_0 (s t)); nra].
    pose proof (Rmult_lt_0_compat K (1 + k * s t ^ 2) Kpos ltac:(lra)).
    pose proof (Rmult_le_pos B_a (1 - k * s t ^ 2) ltac:(lra) ltac:(lra)); lra.
  Qed.

  Lemma root_positive t : 0 < root t.
  Proof.
    destruct (inside_positive t) as (A & B & _).
    unfold root; apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra.
  Qed.

  Lemma functions_derive t : is_derive s t (mu * c t * d t) /\ is_derive c t (- mu * s t * d t) /\
    is_derive d t (- mu * k ^ 2 * s t * c t).
  Proof.
    assert (D : forall f df, (forall u, is_derive f u (df u)) ->
      is_derive (fun t => f (mu * t + phase)) t (mu * df (mu * t + phase))) by (intros;
        now apply derive_at_phase).
    split; [|split]; unfold s, c, d.
    - refine (derive_as _ _ _ _ (D _ _ (derivative_sn _ _ _ _ Jac)) _); ring.
    - refine (derive_as _ _ _ _ (D _ _ (derivative_cn _ _ _ _ Jac)) _); ring.
    - refine (derive_as _ _ _ _ (D _ _ (derivative_dn _ _ _ _ Jac)) _); ring.
  Qed.

  Lemma derive_root t : let w := sqrt (root t) in is_derive (fun t => sqrt (root t)) t
    (w * k * s t * mu * c t * d t * ((K - B_a) / (K * (1 + k * s t ^ 2) + B_a * (1 - k * s t ^ 2))
      + 1 / (1 + k * s t ^ 2))).
  Proof.
    intros w; pose proof (root_positive t) as P; destruct (inside_positive t) as (A & B & _),
      (functions_derive t) as (D & _).
    assert (W : 0 < w /\ w ^ 2 = root t) by now apply root_of.
    unfold root; derive_known; [exact P|].
    match goal with |- context [sqrt ?x] => change (sqrt x) with w end.
    destruct W as (W & W2); apply (Rmult_eq_reg_r (2 * w)); [|lra].
    match goal with |- ?l = ?r => replace r with (2 * w ^ 2 * (k * s t * mu * c t * d t
      * ((K - B_a) / (K * (1 + k * s t ^ 2) + B_a * (1 - k * s t ^ 2)) + 1 / (1 + k * s t ^ 2)))) by ring end.
    rewrite W2; unfold root; field; lra.
  Qed.

  Lemma denominator t : 0 < K + sigma * descended.M_a (names (fun _ => 0) start) t.
  Proof.
    destruct (inside_positive t) as (A & B & _); unfold descended.M_a, descended.dn; cbn -[pow].
    replace (K + _) with ((K * (1 + k * s t ^ 2) + sigma ^ 2 * (B_a * (1 - k * s t ^ 2)))
      / (1 + k * s t ^ 2)) by (field; lra).
    rewrite Sigma, Rmult_1_l; now apply Rdiv_lt_0_compat.
  Qed.

  Lemma derive_psi t : is_derive psi t (rate t).
  Proof.
    apply derive_integral; intros x; pose proof (denominator x) as Q;
      destruct (inside_positive x) as (A & _), (functions_derive x) as (D & _).
    unfold rate, descended.psi_rate, descended.Omega_a, descended.M_a, descended.dn in *;
      cbn -[pow descended.H_ descended.A_a] in *.
    set (H := descended.H_ _); set (Aa := descended.A_a _); auto_derive.
    repeat split; try (eexists; exact D); try lra; apply Rgt_not_eq; exact Q.
  Qed.

  Lemma derive_J t : is_derive J t (mu * s t ^ 2 / (1 - n * s t ^ 2)).
  Proof.
    apply (derive_integral (fun t => mu * s t ^ 2 / (1 - n * s t ^ 2))); intros x.
    destruct (inside_positive x) as (_ & _ & N), (functions_derive x) as (D & _); auto_derive.
    repeat split; try (eexists; exact D); lra.
  Qed.

  Lemma middle_positive : 0 < i_a + rho * Delta * B_d ^ 2 / (C_b / (1 + k)) ^ 2.
  Proof.
    pose proof (pow_lt _ 2 Cp) as C4.
    pose proof (pow_lt _ 2 Ba); pose proof (pow_lt _ 2 Bd).
    assert (B2 : 0 < (1 + k) ^ 2 * B_d ^ 2) by (apply Rmult_lt_0_compat; [apply pow_lt|]; lra).
    assert (A2 : 0 <= i_a * (4 * k * B_a ^ 2)) by (apply Rmult_le_pos; [|apply Rmult_le_pos]; lra).
    replace (i_a + _) with ((i_a * (4 * k * B_a ^ 2) + (i_a + rho * Delta) * ((1 + k) ^ 2 * B_d ^ 2))
      / C_b ^ 2).
    - apply Rdiv_lt_0_compat; [|exact C4]; pose proof (Rmult_lt_0_compat _ _ Id B2); lra.
    - transitivity ((i_a * C_b ^ 2 + rho * Delta * ((1 + k) ^ 2 * B_d ^ 2)) / C_b ^ 2);
        [rewrite C2 at 2; apply (f_equal2 Rdiv); [ring | easy] | field; lra].
  Qed.

  Lemma names_hold p : norm_squared p = 1 -> descended.holds (names psi p).
  Proof.
    intros P.
    assert (B2 : 0 < (1 + k) ^ 2 * B_d ^ 2) by (apply Rmult_lt_0_compat; apply pow_lt; lra).
    assert (A2 : 0 <= 4 * k * B_a ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]).
    pose proof (fun x y X Y => Rlt_le _ _ (Rdiv_lt_0_compat x y X Y)) as quotient.
    constructor; unfold descended.B_b, descended.k_c, descended.nu, descended.A_a, descended.A_b,
      descended.A_d,
      descended.lambda_, descended.c_a, descended.c_b, descended.c_d, descended.i_b, descended.i_d,
        descended.B_b;
      cbn -[pow sqrt RInt]; try (apply Rgt_not_eq; lra); try lra.
    - intros Z; rewrite Z in Rho; lra.
    - replace (_ + _) with (i_a * (4 * k * B_a ^ 2) + (i_a + rho * Delta) * ((1 + k) ^ 2 * B_d ^ 2)) by ring.
      pose proof (Rmult_le_pos i_a _ (Rlt_le _ _ Ia) A2); pose proof (Rmult_lt_0_compat _ _ Id B2); lra.
    - intros t; destruct (inside_positive t); lra.
    - intros t; apply Rgt_not_eq, sqrt_lt_R0, root_positive.
    - intros t; destruct (inside_positive t) as (_ & Q & _); lra.
    - intros t; pose proof (sn_cn _ _ _ _ Jac (mu * t + phase)); unfold s, c; lra.
    - intros t; pose proof (sn_dn _ _ _ _ Jac (mu * t + phase)); unfold s, d; lra.
    - intros t; rewrite pow2_sqrt by (left; apply root_positive); unfold root; ring.
    - unfold norm_squared in P; lra.
    - intros t; pose proof (sin2_cos2 (psi t / 2)); unfold Rsqr in *; lra.
    - apply quotient; lra.
    - apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra].
    - intros t; apply quotient; [apply sqrt_lt_R0, root_positive | apply (inside_positive t)].
    - apply quotient; [lra | apply Rdiv_lt_0_compat; lra].
    - apply quotient; [apply Rdiv_lt_0_compat; lra | apply Rdiv_lt_0_compat; [lra | exact middle_positive]].
    - apply quotient; [lra | apply Rdiv_lt_0_compat; lra].
    - apply quotient; [apply Rmult_lt_0_compat; [now apply Rmult_lt_0_compat | lra] | apply Rdiv_lt_0_compat;
      lra].
    - intros t; apply (is_derive_id (K := R_AbsRing)).
    - intros t; apply (functions_derive t).
    - intros t; apply (functions_derive t).
    - intros t; apply (functions_derive t).
    - intros t; exact (derive_root t).
    - intros t; refine (derive_as _ t _ _ (derive_J t) _).
      change (descended.n (names psi p)) with n; change (descended.mu (names psi p)) with mu.
      replace (s t ^ 2 * n) with (n * s t ^ 2) by ring; unfold Rdiv; ring.
    - intros t; pose proof (derive_psi t) as D; change (descended.psi_rate (names psi p) t) with (rate t).
      set (f := psi) in *; clearbody f; derive_known; change (f t * / 2) with (f t / 2); field.
    - intros t; pose proof (derive_psi t) as D; change (descended.psi_rate (names psi p) t) with (rate t).
      set (f := psi) in *; clearbody f; derive_known; change (f t * / 2) with (f t / 2); field.
  Qed.

  Lemma qbar_unit : norm_squared qbar = 1.
  Proof.
    set (one := Quaternion 1 0 0 0); assert (O : norm_squared one = 1) by (unfold norm_squared; cbn; ring).
    pose proof (proj1 (descended.fact_solution (names psi one) (names_hold one O) 0)) as N.
    unfold norm_squared, qbar; cbn [part_0 part_a part_b part_d].
    unfold descended.q_0, descended.q_a, descended.q_b, descended.q_d in N.
    change (descended.qbar_0 (names psi one)) with (descended.qbar_0 (names psi start)) in N.
    change (descended.qbar_a (names psi one)) with (descended.qbar_a (names psi start)) in N.
    change (descended.qbar_b (names psi one)) with (descended.qbar_b (names psi start)) in N.
    change (descended.qbar_d (names psi one)) with (descended.qbar_d (names psi start)) in N.
    change (descended.p_0 (names psi one)) with 1 in N; change (descended.p_a (names psi one)) with 0 in N.
    change (descended.p_b (names psi one)) with 0 in N; change (descended.p_d (names psi one)) with 0 in N.
    rewrite <- N; ring.
  Qed.

  Lemma instance_holds : descended.holds instance.
  Proof.
    apply names_hold; rewrite norm_of_product, norm_of_conjugate, Unit, qbar_unit by exact H2; ring.
  Qed.

  (* psi is the published one. *)
  Lemma psi_published t : descended.psi instance t = psi t.
  Proof.
    apply Rminus_diag_uniq; transitivity (descended.psi instance 0 - psi 0).
    - apply (constant_in_time (fun t => descended.psi instance t - psi t)); intros x.
      refine (derive_as _ _ _ _ (derive_difference _ _ _ _ _ (descended.fact_psi_is_the_angle instance
        instance_holds x) (derive_psi x)) _).
      apply Rminus_diag_eq; reflexivity.
    - unfold descended.psi; change (descended.t_ instance 0) with 0; change (descended.J_0 instance) with 0.
      change (descended.J instance 0) with (J 0); unfold J, psi.
      rewrite !(RInt_point (V := R_CompleteNormedModule)); unfold zero; cbn; ring.
  Qed.

  Theorem descended_instance : let X := instance in descended.holds X /\
    the_motion h (descended.c_a X) (descended.c_b X) (descended.c_d X)
      (descended.Omega_a X 0) (descended.Omega_b X 0) (descended.Omega_d X 0) start
      (descended.Omega_a X) (descended.Omega_b X) (descended.Omega_d X)
      (fun t => Quaternion (descended.q_0 X t) (descended.q_a X t) (descended.q_b X t) (descended.q_d X t)) /\
    forall t, descended.cos_half_psi X t = cos (descended.psi X t / 2) /\
      descended.sin_half_psi X t = sin (descended.psi X t / 2).
  Proof.
    intros X; split; [exact instance_holds | split; [| intros t; rewrite psi_published; now split]].
    destruct (descended_motion X instance_holds) as (_ & M).
    - apply Rdiv_lt_0_compat; [lra | exact Ia].
    - apply Rdiv_lt_0_compat; [lra | exact middle_positive].
    - apply Rdiv_lt_0_compat; [lra | exact Id].
    - exact (M start Unit eq_refl).
  Qed.
End Instance.

(* The published form from a body and its start: the moments, rates and attitude that are given are those of
   the instance.  k is the modulus after one descent, and phase the argument at the start. *)
Theorem descended_from_start (h rho sigma chi c_a c_b c_d v_a v_b v_d : R) (p : quaternion) :
  circulates h rho sigma chi c_a c_b c_d v_a v_b v_d -> norm_squared p = 1 ->
  let E_a := c_b * (c_a - c_b) * v_b ^ 2 + c_d * (c_a - c_d) * v_d ^ 2 in
  let E_d := c_a * (c_a - c_d) * v_a ^ 2 + c_b * (c_b - c_d) * v_b ^ 2 in
  let A_a := sqrt (E_d / (c_a * (c_a - c_d))) in
  let A_b := sqrt (E_a / (c_b * (c_a - c_b))) in
  let A_d := sqrt (E_a / (c_d * (c_a - c_d))) in
  let tau := - rho * h * sigma in
  forall k, 0 <= k <= 1 -> 4 * k / (1 + k) ^ 2 = E_a * (c_b - c_d) / (E_d * (c_a - c_b)) ->
  forall (sn cn dn : R -> R) (phase : R), jacobi (k ^ 2) sn cn dn ->
  let x := k * sn phase ^ 2 in
  sigma * A_a * ((1 - x) / (1 + x)) = v_a ->
  chi * A_b * ((1 + k) * sn phase / (1 + x)) = v_b ->
  chi * tau * A_d * (cn phase * dn phase / (1 + x)) = v_d ->
  let K := sqrt ((c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2) in
  let X := instance h sigma rho chi (1 / c_a) (rho * (1 / c_d - 1 / c_a)) (c_a * A_a) (c_d * A_d) k K
    ((1 + k) * (c_b * A_b)) phase sn cn dn p in
  descended.holds X /\
  the_motion h c_a c_b c_d v_a v_b v_d p (descended.Omega_a X) (descended.Omega_b X) (descended.Omega_d X)
    (fun t => Quaternion (descended.q_0 X t) (descended.q_a X t) (descended.q_b X t) (descended.q_d X t)).
Proof.
  intros C P E_a E_d A_a A_b A_d tau k Kp M sn cn dn phase J x Sa Sb Sd K X.
  destruct (under_roots _ _ _ _ _ _ _ _ _ _ C) as ((Ea & Ed) & (Qa & Qb & Qd & Ql) & Kq).
  destruct C as [H Rho Sigma Chi Ca Cb Cd Rab Rbd _ _]; fold E_a E_d in Ea, Ed, Qa, Qb, Qd, Ql.
  destruct (root_of _ Qa) as (Aa & Aa2), (root_of _ Qb) as (Ab & Ab2), (root_of _ Qd) as (Ad & Ad2).
  fold A_a in Aa, Aa2; fold A_b in Ab, Ab2; fold A_d in Ad, Ad2.
  pose proof (squares rho c_a c_b c_d A_a A_b A_d (4 * k / (1 + k) ^ 2)
    E_a E_d Ca Cb Cd Rab Rbd Ea Ed Aa2 Ab2 Ad2 M) as Sq.
  pose proof (inverse_b rho c_a c_b c_d A_b A_d E_a E_d Rho Ca Cb Cd Rab Rbd Ea Ed Ab2 Ad2) as Ib.
  pose proof (inverse_d rho c_a c_d Rho) as Id.
  pose proof (Delta_positive rho c_a c_b c_d Ca Cd Rab Rbd) as De.
  set (Delta := rho * (1 / c_d - 1 / c_a)) in *.
  assert (Idp : 0 < 1 / c_a + rho * Delta) by (rewrite Id; apply Rdiv_lt_0_compat; lra).
  assert (Iap : 0 < 1 / c_a) by (apply Rdiv_lt_0_compat; lra).
  destruct (root_of _ Kq) as (Kpos & K2); fold K in Kpos, K2.
  assert (Kd : K ^ 2 = (c_a * A_a) ^ 2 + (c_d * A_d) ^ 2).
  { rewrite K2, !(Rpow_mult_distr _ A_a), !(Rpow_mult_distr _ A_d), Aa2, Ad2; unfold E_a, E_d.
    field; repeat split; try lra; intros Z; assert (Rad : 0 < rho * (c_a - c_d)) by lra; rewrite Z in Rad;
      lra. }
  assert (Cb2 : ((1 + k) * (c_b * A_b)) ^ 2 = (1 + k) ^ 2 * (c_d * A_d) ^ 2 + 4 * k * (c_a * A_a) ^ 2).
  { transitivity ((1 + k) ^ 2 * (c_b * A_b) ^ 2); [ring | rewrite Sq; field; lra]. }
  pose proof (Rmult_lt_0_compat _ _ Cb Ab) as BbP.
  assert (CbP : 0 < (1 + k) * (c_b * A_b)) by (apply Rmult_lt_0_compat; lra).
  destruct (descended_instance h sigma rho chi (1 / c_a) Delta (c_a * A_a) (c_d * A_d) k K ((1 + k)
    * (c_b * A_b)) phase
    sn cn dn p H Sigma Rho Chi Iap Idp De (Rmult_lt_0_compat _ _ Ca Aa) (Rmult_lt_0_compat _ _ Cd Ad)
      Kp J P Kpos Kd CbP Cb2) as (Hold & Mot & _); fold X in Hold, Mot.
  split; [exact Hold|].
  assert (Bb : descended.B_b X = c_b * A_b)
    by (change ((1 + k) * (c_b * A_b) / (1 + k) = c_b * A_b); field; lra).
  assert (Ma : descended.c_a X = c_a) by (change (1 / (1 / c_a) = c_a); field; lra).
  assert (Md : descended.c_d X = c_d).
  { unfold descended.c_d, descended.i_d; change (1 / (1 / c_a + rho * Delta) = c_d); rewrite Id; field; lra. }
  assert (Mb : descended.c_b X = c_b).
  { unfold descended.c_b, descended.i_b; rewrite Bb.
    change (1 / (1 / c_a + rho * Delta * (c_d * A_d) ^ 2 / (c_b * A_b) ^ 2) = c_b); rewrite Ib; field; lra. }
  assert (S0 : descended.s X 0 = sn phase /\ descended.c X 0 = cn phase /\ descended.d X 0 = dn phase).
  { unfold X, instance; cbn [descended.s descended.c descended.d]; rewrite !Rmult_0_r, !Rplus_0_l;
    repeat split. }
  destruct S0 as (S0 & C0 & D0).
  assert (Wa : descended.Omega_a X 0 = v_a).
  { rewrite <- Sa; unfold descended.Omega_a, descended.A_a, descended.dn; rewrite Ma, S0.
    change (descended.sigma X) with sigma; change (descended.k_1 X) with k;
      change (descended.B_a X) with (c_a * A_a).
    fold x; replace (c_a * A_a / c_a) with A_a by (field; lra); unfold Rdiv; ring. }
  assert (Wb : descended.Omega_b X 0 = v_b).
  { rewrite <- Sb; unfold descended.Omega_b, descended.A_b, descended.sn; rewrite Mb, Bb, S0.
    change (descended.chi X) with chi; change (descended.k_1 X) with k.
    fold x; replace (c_b * A_b / c_b) with A_b by (field; lra); unfold Rdiv; ring. }
  assert (Wd : descended.Omega_d X 0 = v_d).
  { rewrite <- Sd; unfold descended.Omega_d, descended.A_d, descended.cn, descended.tau;
    rewrite Md, S0, C0, D0.
    change (descended.chi X) with chi; change (descended.k_1 X) with k;
      change (descended.B_d X) with (c_d * A_d).
    change (descended.rho X) with rho; change (descended.epsilon X) with h;
      change (descended.sigma X) with sigma.
    fold x; replace (c_d * A_d / c_d) with A_d by (field; lra); unfold tau; ring. }
  rewrite Ma, Mb, Md, Wa, Wb, Wd in Mot; exact Mot.
Qed.

(* With functions that Coq has: symmetric bodies, and the separatrix. *)
Theorem descended_by_sines (h sigma rho chi i_a Delta B_a B_d phase : R) (p : quaternion) :
  h ^ 2 = 1 -> sigma ^ 2 = 1 -> rho ^ 2 = 1 -> chi ^ 2 = 1 ->
  0 < i_a -> 0 < i_a + rho * Delta -> 0 < Delta -> 0 < B_a -> 0 < B_d -> norm_squared p = 1 ->
  let K := sqrt (B_a ^ 2 + B_d ^ 2) in
  descended.holds (instance h sigma rho chi i_a Delta B_a B_d 0 K B_d phase sin cos (fun _ => 1) p).
Proof.
  intros ? ? ? ? ? ? ? Ba Bd ? K; pose proof (pow_lt _ 2 Ba); pose proof (pow_lt _ 2 Bd).
  destruct (root_of (B_a ^ 2 + B_d ^ 2)) as (Kp & K2); [lra|]; fold K in Kp, K2.
  apply instance_holds; trivial; [lra | | ring]; replace (0 ^ 2) with 0 by ring; exact jacobi_at_0.
Qed.

Theorem descended_by_tanh (h sigma rho chi i_a Delta B_a B_d phase : R) (p : quaternion) :
  h ^ 2 = 1 -> sigma ^ 2 = 1 -> rho ^ 2 = 1 -> chi ^ 2 = 1 ->
  0 < i_a -> 0 < i_a + rho * Delta -> 0 < Delta -> 0 < B_a -> 0 < B_d -> norm_squared p = 1 ->
  let K := sqrt (B_a ^ 2 + B_d ^ 2) in
  descended.holds (instance h sigma rho chi i_a Delta B_a B_d 1 K (2 * K) phase tanh sech sech p).
Proof.
  intros ? ? ? ? ? ? ? Ba Bd ? K; pose proof (pow_lt _ 2 Ba); pose proof (pow_lt _ 2 Bd).
  destruct (root_of (B_a ^ 2 + B_d ^ 2)) as (Kp & K2); [lra|]; fold K in Kp, K2.
  apply instance_holds; trivial; [lra | | lra | transitivity (4 * K ^ 2); [ring | rewrite K2; ring]].
  replace (1 ^ 2) with 1 by ring; exact jacobi_at_1.
Qed.

(* What an instance of the descended form already supposes, in whatever order. *)
Ltac of_descended N := clear - N; destruct N; first [assumption |
  intros t; unfold separatrix_form.nu, symmetric_form.nu; rewrite (Rmult_comm (_ ^ 2));
    match goal with H : forall t : R, _ |- _ => exact (H t) end].

(* On the separatrix, for bodies of any moments: the forms by theta functions, which are elementary there. *)
Section Separatrix.
  Variables (h sigma rho chi i_a Delta B_a B_d phase : R) (p : quaternion).
  Hypotheses (H2 : h ^ 2 = 1) (Sigma : sigma ^ 2 = 1) (Rho : rho ^ 2 = 1) (Chi : chi ^ 2 = 1).
  Hypotheses (Ia : 0 < i_a) (Id : 0 < i_a + rho * Delta) (De : 0 < Delta) (Ba : 0 < B_a) (Bd : 0 < B_d).
  Hypothesis Unit : norm_squared p = 1.
  Let K := sqrt (B_a ^ 2 + B_d ^ 2).
  Let D := instance h sigma rho chi i_a Delta B_a B_d 1 K (2 * K) phase tanh sech sech p.
  Let names (X_re X_im : R -> R) : separatrix_form.names := {|
    separatrix_form.epsilon := h; separatrix_form.sigma := sigma; separatrix_form.rho := rho;
      separatrix_form.chi := chi;
    separatrix_form.i_a := i_a; separatrix_form.Delta := Delta; separatrix_form.B_a := B_a;
      separatrix_form.B_d := B_d;
    separatrix_form.t_ := fun t => t; separatrix_form.phase := phase; separatrix_form.s := descended.s D;
    separatrix_form.c := descended.c D; separatrix_form.K := K; separatrix_form.w := descended.w D;
    separatrix_form.J := descended.J D; separatrix_form.J_0 := 0;
    separatrix_form.p_0 := part_0 p; separatrix_form.p_a := part_a p; separatrix_form.p_b := part_b p;
    separatrix_form.p_d := part_d p; separatrix_form.Y := sqrt ((K + B_a) * (K - B_a + 1 * (K + B_a)));
    separatrix_form.X_re := X_re; separatrix_form.X_im := X_im;
    separatrix_form.root := fun t => sqrt (1 + descended.s D t ^ 2) |}.
  Let Lambda := separatrix_form.Lambda (names (fun _ => 1) (fun _ => 0)).
  Definition separatrix_instance := names (fun t => cos (Lambda * t)) (fun t => sin (Lambda * t)).

  Theorem separatrix_form_instance : separatrix_form.holds separatrix_instance.
  Proof.
    pose proof (descended_by_tanh h sigma rho chi i_a Delta B_a B_d phase p H2 Sigma Rho Chi Ia Id De Ba Bd
      Unit : descended.holds D) as N.
    pose proof (pow_lt _ 2 Ba); pose proof (pow_lt _ 2 Bd).
    destruct (root_of (B_a ^ 2 + B_d ^ 2)) as (Kp & K2); [lra|]; fold K in Kp, K2.
    destruct (root_of ((K + B_a) * (K - B_a + 1 * (K + B_a)))) as (Yp & Y2); [nra|].
    assert (Cp : forall t, 0 < descended.c D t) by (intros t; apply sech_positive).
    assert (Rp : forall t, 0 < sqrt (1 + descended.s D t ^ 2) /\
      sqrt (1 + descended.s D t ^ 2) ^ 2 = 1 + descended.s D t ^ 2)
      by (intros t; pose proof (pow2_ge_0 (descended.s D t)); apply root_of; lra).
    assert (S0 : forall t, 0 < descended.s_0 D t).
    { intros t; unfold descended.s_0; pose proof (descended.sign_3 D N t) as S;
      pose proof (descended.unit_12 D N t) as W.
      pose proof (descended.unit_10 D N t) as U; apply Rdiv_lt_0_compat; [|change (0 < 2 * K); lra].
      destruct S as [S|S]; [exact S|]; exfalso; apply W; unfold descended.nu in S.
      apply (Rmult_eq_reg_r (/ (1 + descended.k_1 D * descended.s D t ^ 2))); [rewrite Rmult_0_l; symmetry;
        exact S | now apply Rinv_neq_0_compat]. }
    assert (Quotient : forall t, 0 < separatrix_form.R_ separatrix_instance t).
    { intros t; unfold separatrix_form.R_, separatrix_form.s_0, separatrix_form.nu; rewrite (Rmult_comm (_ ^ 2)).
      exact (Rdiv_lt_0_compat _ _ (Rmult_lt_0_compat _ _ (proj1 (Rp t)) (S0 t)) (Cp t)). }
    constructor; try of_descended N.
    - intros t; apply Rgt_not_eq, Cp.
    - intros t; apply Rgt_not_eq, (Rp t).
    - exact R1_neq_R0.
    - apply Rgt_not_eq; exact Yp.
    - intros t; apply Rgt_not_eq, Quotient.
    - unfold norm_squared in Unit; cbn -[pow]; lra.
    - change (sqrt ((K + B_a) * (K - B_a + 1 * (K + B_a))) ^ 2 - (B_a + K) * (K - B_a + 1 * (B_a + K)) = 0);
      rewrite Y2; ring.
    - intros t; pose proof (sin2_cos2 (Lambda * t)) as S; unfold Rsqr in S; cbn -[pow Lambda]; lra.
    - intros t; pose proof (proj2 (Rp t)) as S; cbn -[pow descended.s sqrt] in *; lra.
    - exact Rle_0_1.
    - left; exact Yp.
    - left; exact Ba.
    - change (0 <= 2 * K); lra.
    - intros t; left; apply Quotient.
    - intros t; left; apply Cp.
    - intros t; left; apply (Rp t).
    - intros t; change (is_derive (fun t => cos (Lambda * t)) t (- sin (Lambda * t) * Lambda));
      clearbody Lambda.
      auto_derive; [easy | ring].
    - intros t; change (is_derive (fun t => sin (Lambda * t)) t (cos (Lambda * t) * Lambda));
      clearbody Lambda.
      auto_derive; [easy | ring].
    - intros t; clear Quotient; pose proof (descended.rate_s D N t) as E; destruct (Rp t) as (R1 & R2).
      change (is_derive (fun t => sqrt (1 + descended.s D t ^ 2)) t
        (descended.s D t * descended.c D t ^ 2 * descended.mu D / sqrt (1 + descended.s D t ^ 2))).
      change (descended.d D t) with (descended.c D t) in E; pose proof (pow2_ge_0 (descended.s D t)).
      set (m := descended.mu D) in *; set (s := descended.s D) in *; set (c := descended.c D t) in *;
        clearbody m s c.
      derive_known; [lra|].
      match goal with |- context [sqrt ?x] => replace x with (1 + s t ^ 2) by ring end; field; lra.
  Qed.

  Theorem theta_form_instance : theta_form.holds (separatrix_form.as_theta_form separatrix_instance).
  Proof. exact (separatrix_form.models_theta_form _ separatrix_form_instance). Qed.
End Separatrix.

(* What the form in the complementary nome supposes is the same, of other functions. *)
Definition as_hyperbolic_form (X : theta_form.names) : hyperbolic_form.names := {|
  hyperbolic_form.epsilon := theta_form.epsilon X; hyperbolic_form.sigma := theta_form.sigma X;
  hyperbolic_form.rho := theta_form.rho X; hyperbolic_form.chi := theta_form.chi X;
  hyperbolic_form.i_a := theta_form.i_a X; hyperbolic_form.Delta := theta_form.Delta X;
  hyperbolic_form.B_a := theta_form.B_a X; hyperbolic_form.B_d := theta_form.B_d X;
  hyperbolic_form.k_1 := theta_form.k_1 X; hyperbolic_form.C_b := theta_form.C_b X;
  hyperbolic_form.t_ := theta_form.t_ X; hyperbolic_form.phase := theta_form.phase X;
  hyperbolic_form.s := theta_form.s X; hyperbolic_form.c := theta_form.c X;
  hyperbolic_form.d := theta_form.d X; hyperbolic_form.K := theta_form.K X;
  hyperbolic_form.w := theta_form.w X; hyperbolic_form.J := theta_form.J X;
  hyperbolic_form.J_0 := theta_form.J_0 X; hyperbolic_form.p_0 := theta_form.p_0 X;
  hyperbolic_form.p_a := theta_form.p_a X; hyperbolic_form.p_b := theta_form.p_b X;
  hyperbolic_form.p_d := theta_form.p_d X; hyperbolic_form.root_k := theta_form.root_k X;
  hyperbolic_form.Y := theta_form.Y X; hyperbolic_form.zeta := theta_form.zeta X;
  hyperbolic_form.Z_u := theta_form.Z_u X; hyperbolic_form.T4_re := theta_form.T4_re X;
  hyperbolic_form.T4_im := theta_form.T4_im X; hyperbolic_form.R_ := theta_form.R_ X;
  hyperbolic_form.X_re := theta_form.X_re X; hyperbolic_form.X_im := theta_form.X_im X |}.
Theorem hyperbolic_form_instance X : theta_form.holds X -> hyperbolic_form.holds (as_hyperbolic_form X).
Proof. intros []; constructor; assumption. Qed.

(* Symmetric bodies. *)
Section Symmetric.
  Variables (h sigma rho chi i_a Delta B_a B_d phase : R) (p : quaternion).
  Hypotheses (H2 : h ^ 2 = 1) (Sigma : sigma ^ 2 = 1) (Rho : rho ^ 2 = 1) (Chi : chi ^ 2 = 1).
  Hypotheses (Ia : 0 < i_a) (Id : 0 < i_a + rho * Delta) (De : 0 < Delta) (Ba : 0 < B_a) (Bd : 0 < B_d).
  Hypothesis Unit : norm_squared p = 1.
  Let K := sqrt (B_a ^ 2 + B_d ^ 2).
  Let D := instance h sigma rho chi i_a Delta B_a B_d 0 K B_d phase sin cos (fun _ => 1) p.
  Let names (X_re X_im : R -> R) : symmetric_form.names := {|
    symmetric_form.epsilon := h; symmetric_form.sigma := sigma; symmetric_form.rho := rho;
      symmetric_form.chi := chi;
    symmetric_form.i_a := i_a; symmetric_form.Delta := Delta; symmetric_form.B_a := B_a;
      symmetric_form.B_d := B_d;
    symmetric_form.t_ := fun t => t; symmetric_form.phase := phase; symmetric_form.s := descended.s D;
    symmetric_form.c := descended.c D; symmetric_form.K := K; symmetric_form.w := descended.w D;
    symmetric_form.J := descended.J D; symmetric_form.J_0 := 0;
    symmetric_form.p_0 := part_0 p; symmetric_form.p_a := part_a p; symmetric_form.p_b := part_b p;
    symmetric_form.p_d := part_d p; symmetric_form.X_re := X_re; symmetric_form.X_im := X_im |}.
  Let Lambda := symmetric_form.Lambda (names (fun _ => 1) (fun _ => 0)).
  Definition symmetric_instance := names (fun t => cos (Lambda * t)) (fun t => sin (Lambda * t)).

  Theorem symmetric_form_instance : symmetric_form.holds symmetric_instance.
  Proof.
    pose proof (descended_by_sines h sigma rho chi i_a Delta B_a B_d phase p H2 Sigma Rho Chi Ia Id De Ba Bd
      Unit
      : descended.holds D) as N.
    constructor; try of_descended N.
    - unfold norm_squared in Unit; cbn -[pow]; lra.
    - intros t; pose proof (sin2_cos2 (Lambda * t)) as S; unfold Rsqr in S; cbn -[pow Lambda]; lra.
    - left; exact Bd.
    - intros t; change (is_derive (fun t => cos (Lambda * t)) t (- sin (Lambda * t) * Lambda));
      clearbody Lambda.
      auto_derive; [easy | ring].
    - intros t; change (is_derive (fun t => sin (Lambda * t)) t (cos (Lambda * t) * Lambda));
      clearbody Lambda.
      auto_derive; [easy | ring].
  Qed.
End Symmetric.

(* Near the separatrix and on it, by an integral of the third kind, where dn has no zero. *)
Section Near.
  Variables (h sigma rho chi i_a Delta B_a B_d k K C_b phase : R) (sn cn dn : R -> R) (p : quaternion).
  Hypotheses (H2 : h ^ 2 = 1) (Sigma : sigma ^ 2 = 1) (Rho : rho ^ 2 = 1) (Chi : chi ^ 2 = 1).
  Hypotheses (Ia : 0 < i_a) (Id : 0 < i_a + rho * Delta) (De : 0 < Delta) (Ba : 0 < B_a) (Bd : 0 < B_d).
  Hypotheses (Kp : 0 < k <= 1) (Jac : jacobi (k ^ 2) sn cn dn) (Dn : forall u, dn u <> 0).
  Hypotheses (Unit : norm_squared p = 1) (Kpos : 0 < K) (K2 : K ^ 2 = B_a ^ 2 + B_d ^ 2).
  Hypotheses (Cp : 0 < C_b) (C2 : C_b ^ 2 = (1 + k) ^ 2 * B_d ^ 2 + 4 * k * B_a ^ 2).

  Let D := instance h sigma rho chi i_a Delta B_a B_d k K C_b phase sn cn dn p.
  Let names (L R_ X_re X_im : R -> R) : pi_near.names := {|
    pi_near.epsilon := descended.epsilon D; pi_near.sigma := descended.sigma D;
    pi_near.rho := descended.rho D; pi_near.chi := descended.chi D; pi_near.i_a := descended.i_a D;
    pi_near.Delta := descended.Delta D; pi_near.B_a := descended.B_a D; pi_near.B_d := descended.B_d D;
    pi_near.k_1 := descended.k_1 D; pi_near.C_b := descended.C_b D; pi_near.t_ := descended.t_ D;
    pi_near.phase := descended.phase D; pi_near.s := descended.s D; pi_near.c := descended.c D;
    pi_near.d := descended.d D; pi_near.K := descended.K D; pi_near.w := descended.w D;
    pi_near.J := descended.J D; pi_near.J_0 := descended.J_0 D; pi_near.p_0 := descended.p_0 D;
    pi_near.p_a := descended.p_a D; pi_near.p_b := descended.p_b D; pi_near.p_d := descended.p_d D;
    pi_near.root_k := sqrt k; pi_near.Y := sqrt ((K + B_a) * (K - B_a + k * (K + B_a))); pi_near.zeta := 0;
    pi_near.L := L; pi_near.R_ := R_; pi_near.K_1 := 0; pi_near.j := 0; pi_near.X_re := X_re;
    pi_near.X_im := X_im |}.
  Let zero (t : R) := 0.
  Let base := names zero zero zero zero.
  Let V_re := pi_near.V_re base.
  Let V_im := pi_near.V_im base.
  Let size t := V_re t ^ 2 + V_im t ^ 2.
  Let angle := RInt (fun t => pi_near.psi_rate base t / 2 - pi_near.T_rate base t) 0.
  Definition near_instance := names (RInt (fun t => descended.s D t ^ 2 * pi_near.mu base
    / (1 - descended.s D t ^ 2 * pi_near.n_2 base)) 0) (fun t => sqrt (size t))
    (fun t => cos (angle t)) (fun t => sin (angle t)).

  Lemma near_holds : descended.holds D.
  Proof. apply instance_holds; trivial; lra. Qed.

  Lemma Y_positive : 0 < pi_near.Y base /\ pi_near.Y base ^ 2 = (K + B_a) * (K - B_a + k * (K + B_a)).
  Proof.
    apply root_of; pose proof (pow_lt _ 2 Bd); apply Rmult_lt_0_compat; [lra|].
    assert (B_a < K) by nra; assert (0 < k * (K + B_a)) by (apply Rmult_lt_0_compat; lra); lra.
  Qed.

  Lemma z_positive : 0 < pi_near.z base.
  Proof. apply Rdiv_lt_0_compat; [exact Cp | apply Y_positive]. Qed.

  Lemma near_inside t : 0 < 1 - descended.s D t ^ 2 * pi_near.n base /\
    0 < 1 - descended.s D t ^ 2 * pi_near.n_2 base.
  Proof.
    rewrite !(Rmult_comm (_ ^ 2)); split; [exact (proj2 (proj2 (inside_positive Delta B_a B_d k K C_b phase sn cn dn Ba Bd ltac:(lra)
      Jac Kpos K2 t)))|].
    assert (P : 0 <= pi_near.delta base).
    { unfold pi_near.delta, pi_near.m_c; change (pi_near.k_1 base) with k; apply Rmult_le_pos; [nra|].
      left; apply Rinv_0_lt_compat, pow_lt, z_positive. }
    pose proof (descended.relation_5 D near_holds t) as C; pose proof (descended.relation_6 D near_holds t)
      as E.
    change (descended.k_1 D) with k in E.
    pose proof (pow2_gt_0 _ (Dn (descended.mu D * t + phase)) : 0 < descended.d D t ^ 2) as Q.
    pose proof (pow2_ge_0 (descended.s D t)) as S; pose proof (pow2_ge_0 (descended.c D t)).
    unfold pi_near.n_2; set (s2 := descended.s D t ^ 2) in *; set (c2 := descended.c D t ^ 2) in *.
    replace (1 - (1 - pi_near.delta base) * s2) with (c2 + pi_near.delta base * s2) by lra.
    destruct (Req_dec c2 0) as [Z|Z]; [|pose proof (Rmult_le_pos _ _ P S); lra].
    assert (S1 : s2 = 1) by lra; rewrite S1 in *.
    assert (K1 : k ^ 2 < 1) by lra; unfold pi_near.delta, pi_near.m_c; change (pi_near.k_1 base) with k.
    pose proof (Rdiv_lt_0_compat (1 - k ^ 2) (pi_near.z base ^ 2) ltac:(lra) (pow_lt _ 2 z_positive)); lra.
  Qed.

  Lemma size_positive t : 0 < size t.
  Proof.
    unfold size; pose proof (pow2_ge_0 (V_im t)).
    assert (N : V_re t <> 0).
    { change (C_b * dn (descended.mu D * t + phase) * (B_a + K) <> 0);
      pose proof (Dn (descended.mu D * t + phase)).
      repeat apply Rmult_integral_contrapositive_currified; lra || assumption. }
    pose proof (pow2_gt_0 _ N); lra.
  Qed.

  Lemma derive_angle t : is_derive angle t (pi_near.psi_rate base t / 2 - pi_near.T_rate base t).
  Proof.
    apply (derive_integral (fun t => pi_near.psi_rate base t / 2 - pi_near.T_rate base t)); intros x.
    pose proof (descended.rate_s D near_holds x) as Ds; pose proof (descended.rate_c D near_holds x) as Dc;
      pose proof (descended.rate_d D near_holds x) as Dd; destruct (near_inside x) as (N1 & N2);
        pose proof z_positive as Z.
    pose proof (denominator h sigma rho chi i_a Delta B_a B_d k K C_b phase sn cn dn p Sigma Ba Bd ltac:(lra)
      Jac Kpos K2 x) as Q.
    change (0 < K + sigma * pi_near.M_a base x) in Q.
    pose proof (descended.unit_10 D near_holds x) as U; change (descended.k_1 D) with k in U.
    unfold pi_near.psi_rate, pi_near.T_rate, pi_near.Omega_a, pi_near.M_a, pi_near.dn in *.
    change (pi_near.s base) with (descended.s D) in *; change (pi_near.c base) with (descended.c D) in *.
    change (pi_near.d base) with (descended.d D) in *; change (pi_near.k_1 base) with k in *;
      change (pi_near.K base) with K in *.
    change (pi_near.sigma base) with sigma in *; change (pi_near.B_a base) with B_a in *.
    set (a1 := pi_near.H_ base); set (a2 := pi_near.A_a base); set (a3 := pi_near.mu base);
      set (a4 := pi_near.slope base).
    set (a5 := pi_near.z base) in *; set (a6 := pi_near.n base) in *; set (a7 := pi_near.n_2 base) in *.
    set (a8 := pi_near.rho base); set (fs := descended.s D) in *; set (fc := descended.c D) in *;
      set (fd := descended.d D) in *.
    clearbody a1 a2 a3 a4 a5 a6 a7 a8 fs fc fd; auto_derive.
    repeat split; try (eexists; eassumption); try lra.
    all: try (apply Rgt_not_eq; repeat apply Rmult_lt_0_compat; lra).
    all: try exact U; try (apply Rgt_not_eq; exact Q).
  Qed.

  Theorem pi_near_instance : pi_near.holds near_instance.
  Proof.
    pose proof near_holds as N; destruct Y_positive as (Yp & Y2); pose proof z_positive as Z.
    assert (Rk : 0 < sqrt k /\ sqrt k ^ 2 = k) by (apply root_of; lra).
    assert (Rp : forall t, 0 < sqrt (size t) /\ sqrt (size t) ^ 2 = size t) by (intros t;
      apply root_of, size_positive).
    constructor; try of_descended N.
    - apply Rgt_not_eq; exact (proj1 Rk).
    - apply Rgt_not_eq; exact Yp.
    - apply Rgt_not_eq; exact Z.
    - apply Rgt_not_eq; change (0 < 1 + k * pi_near.x base ^ 2).
      pose proof (Rmult_le_pos k _ ltac:(lra) (pow2_ge_0 (pi_near.x base))); lra.
    - intros t; apply Rgt_not_eq; exact (proj2 (near_inside t)).
    - intros t; apply Rgt_not_eq; exact (proj1 (Rp t)).
    - change (- k + sqrt k ^ 2 = 0); lra.
    - change (pi_near.Y base ^ 2 - (B_a + K) * (K - B_a + k * (B_a + K)) = 0); rewrite Y2; ring.
    - intros t; change (sqrt (size t) ^ 2 - V_re t ^ 2 - V_im t ^ 2 = 0); rewrite (proj2 (Rp t));
      unfold size; ring.
    - intros t; change (-1 + cos (angle t) ^ 2 + sin (angle t) ^ 2 = 0).
      pose proof (sin2_cos2 (angle t)) as S; unfold Rsqr in S; lra.
    - left; exact (proj1 Rk).
    - left; exact Yp.
    - left; exact Ba.
    - left; exact Cp.
    - intros t; left; exact (proj1 (Rp t)).
    - intros t; left; change (0 < sqrt (size t) / (pi_near.Y base * (B_a + K))).
      apply Rdiv_lt_0_compat; [exact (proj1 (Rp t)) | apply Rmult_lt_0_compat; lra].
    - intros t; apply (derive_integral (fun t => descended.s D t ^ 2 * pi_near.mu base
        / (1 - descended.s D t ^ 2 * pi_near.n_2 base))); intros x.
      pose proof (descended.rate_s D N x) as E; pose proof (proj2 (near_inside x)).
      set (a := pi_near.mu base); set (b := pi_near.n_2 base) in *; set (f := descended.s D) in *;
        clearbody a b f.
      auto_derive; repeat split; try (eexists; exact E); lra.
    - intros t; destruct (Rp t) as (R1 & R2).
      pose proof (descended.rate_s D N t) as Es; pose proof (descended.rate_c D N t) as Ec;
        pose proof (descended.rate_d D N t) as Ed.
      set (rate := (- k ^ 2 * C_b * descended.s D t * descended.c D t * descended.mu D * V_re t * (B_a + K)
        + V_im t * (rho * B_d * k * descended.s D t ^ 2 * descended.d D t * descended.mu D
            * (K - B_a + k * (B_a + K))
          - rho * B_d * k * descended.c D t ^ 2 * descended.d D t * descended.mu D * (K - B_a + k * (B_a + K))))).
      change (is_derive (fun t => sqrt (size t)) t (rate / sqrt (size t))).
      assert (E : is_derive size t (2 * rate)).
      { unfold rate; change size with (fun t => (C_b * descended.d D t * (B_a + K)) ^ 2
          + (- rho * B_d * k * descended.s D t * descended.c D t * (K - B_a + k * (B_a + K))) ^ 2).
        change (V_re t) with (C_b * descended.d D t * (B_a + K)).
        change (V_im t) with (- rho * B_d * k * descended.s D t * descended.c D t
          * (K - B_a + k * (B_a + K))).
        change (descended.k_1 D) with k in *.
        set (m := descended.mu D) in *; set (fs := descended.s D) in *; set (fc := descended.c D) in *;
          set (fd := descended.d D) in *.
        clearbody m fs fc fd; derive_known; ring. }
      clearbody rate.
      pose proof (size_positive t) as P; clearbody size.
      derive_known; [exact P | field; lra].
    - intros t; pose proof (derive_angle t) as E.
      change (is_derive (fun t => cos (angle t)) t
        (sin (angle t) * (pi_near.T_rate base t - pi_near.psi_rate base t / 2))).
      set (v := pi_near.psi_rate base t / 2) in *; set (w := pi_near.T_rate base t) in *;
        clearbody angle v w; derive_known; ring.
    - intros t; pose proof (derive_angle t) as E.
      change (is_derive (fun t => sin (angle t)) t
        (cos (angle t) * (pi_near.psi_rate base t / 2 - pi_near.T_rate base t))).
      clearbody angle; set (v := pi_near.psi_rate base t / 2 - _) in *; clearbody v; derive_known; ring.
  Qed.
End Near.

Theorem pi_near_by_tanh (h sigma rho chi i_a Delta B_a B_d phase : R) (p : quaternion) :
  h ^ 2 = 1 -> sigma ^ 2 = 1 -> rho ^ 2 = 1 -> chi ^ 2 = 1 ->
  0 < i_a -> 0 < i_a + rho * Delta -> 0 < Delta -> 0 < B_a -> 0 < B_d -> norm_squared p = 1 ->
  let K := sqrt (B_a ^ 2 + B_d ^ 2) in
  pi_near.holds (near_instance h sigma rho chi i_a Delta B_a B_d 1 K (2 * K) phase tanh sech sech p).
Proof.
  intros ? ? ? ? ? ? ? Ba Bd ? K; pose proof (pow_lt _ 2 Ba); pose proof (pow_lt _ 2 Bd).
  destruct (root_of (B_a ^ 2 + B_d ^ 2)) as (Kp & K2); [lra|]; fold K in Kp, K2.
  apply pi_near_instance; trivial; [lra | | | lra | transitivity (4 * K ^ 2); [ring | rewrite K2; ring]].
  - replace (1 ^ 2) with 1 by ring; exact jacobi_at_1.
  - intros u; apply Rgt_not_eq, sech_positive.
Qed.

(* Far from the separatrix. *)
Section Far.
  Variables (h sigma rho chi i_a Delta B_a B_d k K C_b phase : R) (sn cn dn : R -> R) (p : quaternion).
  Hypotheses (H2 : h ^ 2 = 1) (Sigma : sigma ^ 2 = 1) (Rho : rho ^ 2 = 1) (Chi : chi ^ 2 = 1).
  Hypotheses (Ia : 0 < i_a) (Id : 0 < i_a + rho * Delta) (De : 0 < Delta) (Ba : 0 < B_a) (Bd : 0 < B_d).
  Hypotheses (Kp : 0 < k < 1) (Jac : jacobi (k ^ 2) sn cn dn).
  Hypotheses (Unit : norm_squared p = 1) (Kpos : 0 < K) (K2 : K ^ 2 = B_a ^ 2 + B_d ^ 2).
  Hypotheses (Cp : 0 < C_b) (C2 : C_b ^ 2 = (1 + k) ^ 2 * B_d ^ 2 + 4 * k * B_a ^ 2).

  Let D := instance h sigma rho chi i_a Delta B_a B_d k K C_b phase sn cn dn p.
  Let names (L : R -> R) : pi_far.names := {|
    pi_far.epsilon := descended.epsilon D; pi_far.sigma := descended.sigma D;
    pi_far.rho := descended.rho D; pi_far.chi := descended.chi D; pi_far.i_a := descended.i_a D;
    pi_far.Delta := descended.Delta D; pi_far.B_a := descended.B_a D; pi_far.B_d := descended.B_d D;
    pi_far.k_1 := descended.k_1 D; pi_far.C_b := descended.C_b D; pi_far.t_ := descended.t_ D;
    pi_far.phase := descended.phase D; pi_far.s := descended.s D; pi_far.c := descended.c D;
    pi_far.d := descended.d D; pi_far.K := descended.K D; pi_far.w := descended.w D;
    pi_far.J := descended.J D; pi_far.J_0 := descended.J_0 D; pi_far.p_0 := descended.p_0 D;
    pi_far.p_a := descended.p_a D; pi_far.p_b := descended.p_b D; pi_far.p_d := descended.p_d D;
    pi_far.root_k := sqrt k; pi_far.Y := sqrt ((K + B_a) * (K - B_a + k * (K + B_a))); pi_far.zeta := 0;
    pi_far.L := L; pi_far.X_re := descended.cos_half_psi D; pi_far.X_im := descended.sin_half_psi D |}.
  Let base := names (fun _ => 0).
  Let L_rate t := - descended.c D t ^ 2 * pi_far.mu base * pi_far.z base ^ 2
    / (pi_far.m_c base * (1 - descended.s D t ^ 2 * pi_far.n base)).
  Definition far_instance := names (RInt L_rate 0).

  Theorem pi_far_instance : pi_far.holds far_instance.
  Proof.
    assert (N : descended.holds D) by (apply instance_holds; trivial; lra).
    assert (Y : 0 < pi_far.Y base /\ pi_far.Y base ^ 2 = (K + B_a) * (K - B_a + k * (K + B_a))).
    { apply root_of; pose proof (pow_lt _ 2 Bd); apply Rmult_lt_0_compat; [lra|].
      assert (B_a < K) by nra; assert (0 < k * (K + B_a)) by (apply Rmult_lt_0_compat; lra); lra. }
    destruct Y as (Yp & Y2).
    assert (Rk : 0 < sqrt k /\ sqrt k ^ 2 = k) by (apply root_of; lra).
    assert (M : 0 < pi_far.m_c base) by (change (0 < 1 - k ^ 2); nra).
    assert (I : forall t, 0 < 1 - pi_far.n base * descended.s D t ^ 2).
    { intros t; exact (proj2 (proj2 (inside_positive Delta B_a B_d k K C_b phase sn cn dn Ba Bd ltac:(lra)
      Jac Kpos K2 t))). }
    constructor; try of_descended N.
    - apply Rgt_not_eq; exact (proj1 Rk).
    - apply Rgt_not_eq; exact Yp.
    - apply Rgt_not_eq; exact (Rdiv_lt_0_compat _ _ Cp Yp).
    - apply Rgt_not_eq; change (0 < 1 + k * pi_far.x base ^ 2).
      pose proof (Rmult_le_pos k _ ltac:(lra) (pow2_ge_0 (pi_far.x base))); lra.
    - intros t; change (descended.d D t <> 0); intros Z.
      pose proof (descended.relation_5 D N t) as A; pose proof (descended.relation_6 D N t) as B.
      rewrite Z in B; change (descended.k_1 D) with k in B; pose proof (pow2_ge_0 (descended.c D t)).
      assert (k ^ 2 < 1) by nra; pose proof (pow2_ge_0 (descended.s D t)); pose proof (pow2_ge_0 k); nra.
    - change (1 - k <> 0); lra.
    - change (- k + sqrt k ^ 2 = 0); lra.
    - change (pi_far.Y base ^ 2 - (B_a + K) * (K - B_a + k * (B_a + K)) = 0); rewrite Y2; ring.
    - intros t; pose proof (descended.relation_10 D N t).
      change (-1 + descended.cos_half_psi D t ^ 2 + descended.sin_half_psi D t ^ 2 = 0); lra.
    - left; exact (proj1 Rk).
    - left; exact Yp.
    - left; exact Ba.
    - left; exact Cp.
    - intros t; apply (derive_integral L_rate); intros x; specialize (I x).
      pose proof (descended.rate_s D N x) as Es; pose proof (descended.rate_c D N x) as Ec; unfold L_rate.
      set (a := pi_far.mu base); set (b := pi_far.z base); set (m := pi_far.m_c base) in *;
        set (n := pi_far.n base) in *.
      set (fs := descended.s D) in *; set (fc := descended.c D) in *; clearbody a b m n fs fc.
      auto_derive; repeat split; try (eexists; eassumption); apply Rgt_not_eq, Rmult_lt_0_compat; lra.
    - intros t; refine (derive_as _ t _ _ (descended.rate_cos_half_psi D N t) _).
      change (- (descended.psi_rate D t / 2) * descended.sin_half_psi D t
        = - descended.sin_half_psi D t * descended.psi_rate D t / 2); field.
    - intros t; refine (derive_as _ t _ _ (descended.rate_sin_half_psi D N t) _).
      change (descended.psi_rate D t / 2 * descended.cos_half_psi D t
        = descended.cos_half_psi D t * descended.psi_rate D t / 2); field.
  Qed.
End Far.
