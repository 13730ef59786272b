(* What generated code evaluates: the forms that the ledger publishes are the motion, each under what
   the context of its name supposes (its record `holds`), and of a body with positive moments.

   Start: rates start where these functions do.  The attitude starts at any given one, if the factor p in
   front is the published one: that attitude times the conjugate of qbar at t = 0. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Rigidsym.theorems Require Import motion pull_back.
From Rigidsym.contexts Require descended theta_form hyperbolic_form separatrix_form symmetric_form pi_near pi_far.
Open Scope R_scope.

(* The motion, from rates at t = 0 and from any attitude. *)
Definition moves (h c_a c_b c_d : R) (w_a w_b w_d : R -> R) (p : quaternion) (qbar q : R -> quaternion) : Prop :=
  0 < c_a -> 0 < c_b -> 0 < c_d ->
  (forall t, norm_squared (q t) = 1) /\
  forall start, norm_squared start = 1 -> p = product h start (conjugate (qbar 0)) ->
    the_motion h c_a c_b c_d (w_a 0) (w_b 0) (w_d 0) start w_a w_b w_d q.

Lemma moves_from h c_a c_b c_d w_a w_b w_d p qbar q :
  h ^ 2 = 1 -> (forall t, q t = product h p (qbar t)) -> euler h c_a c_b c_d w_a w_b w_d ->
  (forall t, norm_squared (q t) = 1) -> kinematics h w_a w_b w_d q ->
  moves h c_a c_b c_d w_a w_b w_d p qbar q.
Proof.
  unfold moves; intros H F E Q D Ca Cb Cd; split; [exact Q|]; intros start S P.
  assert (N : norm_squared (qbar 0) = 1).
  { pose proof (Q 0) as N; rewrite F, norm_of_product, P, norm_of_product, norm_of_conjugate, S in N by exact H.
    pose proof (pow2_ge_0 (part_0 (qbar 0))); pose proof (pow2_ge_0 (part_a (qbar 0)));
      pose proof (pow2_ge_0 (part_b (qbar 0))); pose proof (pow2_ge_0 (part_d (qbar 0))).
    assert (0 <= norm_squared (qbar 0)) by (unfold norm_squared; lra).
    set (n := norm_squared (qbar 0)) in *; clearbody n; nra. }
  apply unique; trivial; constructor; trivial.
  rewrite F, P; exact (from_start_at_start h start qbar H N).
Qed.

(* A sign, as the ledger supposes it. *)
Lemma sign_of h : h ^ 2 - 1 = 0 -> h ^ 2 = 1.
Proof. lra. Qed.

(* What the ledger says of a form, in whatever order it prints its terms. *)
Ltac from_ledger sign product_in_front rates solution :=
  apply moves_from; [exact (sign_of _ sign) | product_in_front
    | exact rates
    | intros t; exact (proj1 (solution t))
    | intros t; let D0 := fresh in let Da := fresh in let Db := fresh in let Dd := fresh in
      destruct (solution t) as (_ & D0 & Da & Db & Dd); refine (conj _ (conj _ (conj _ _)));
      [refine (derive_as _ _ _ _ D0 _) | refine (derive_as _ _ _ _ Da _)
      | refine (derive_as _ _ _ _ Db _) | refine (derive_as _ _ _ _ Dd _)]; cbn; field].

Lemma descended_rates X : descended.holds X ->
  euler (descended.epsilon X) (descended.c_a X) (descended.c_b X) (descended.c_d X)
    (descended.Omega_a X) (descended.Omega_b X) (descended.Omega_d X).
Proof. intros H t; pose proof (descended.fact_euler X H t) as E; as_euler E. Qed.

Lemma same_rates h c_a c_b c_d w_a w_b w_d u_a u_b u_d : euler h c_a c_b c_d w_a w_b w_d ->
  (forall t, w_a t = u_a t /\ w_b t = u_b t /\ w_d t = u_d t) -> euler h c_a c_b c_d u_a u_b u_d.
Proof.
  intros E Q t; destruct (E t) as (Da & Db & Dd), (Q t) as (Qa & Qb & Qd); rewrite Qa, Qb, Qd in *.
  split; [|split];
    [refine (is_derive_ext _ _ t _ _ Da) | refine (is_derive_ext _ _ t _ _ Db)
    | refine (is_derive_ext _ _ t _ _ Dd)]; intros u; apply Q.
Qed.

(* With k_1 = 0 or 1, a form prints its functions in an order of its own. *)
Lemma symmetric_rates X : symmetric_form.holds X ->
  euler (symmetric_form.epsilon X) (symmetric_form.c_a X) (symmetric_form.c_b X) (symmetric_form.c_d X)
    (symmetric_form.Omega_a X) (symmetric_form.Omega_b X) (symmetric_form.Omega_d X).
Proof.
  intros H; apply (same_rates _ _ _ _ _ _ _ _ _ _ (descended_rates _ (symmetric_form.models_descended X H))).
  intros t; pose proof (pow2_ge_0 (symmetric_form.s X t)); repeat split; refine (f_equal (Rmult _) _);
    unfold descended.sn, descended.cn, descended.dn, symmetric_form.sn, symmetric_form.cn, symmetric_form.dn;
    cbn -[pow]; unfold symmetric_form.k_1, symmetric_form.d; field; lra.
Qed.

Lemma separatrix_rates X : separatrix_form.holds X ->
  euler (separatrix_form.epsilon X) (separatrix_form.c_a X) (separatrix_form.c_b X) (separatrix_form.c_d X)
    (separatrix_form.Omega_a X) (separatrix_form.Omega_b X) (separatrix_form.Omega_d X).
Proof.
  intros H; apply (same_rates _ _ _ _ _ _ _ _ _ _ (descended_rates _ (theta_form.models_descended _ (separatrix_form.models_theta_form X H)))).
  intros t; pose proof (pow2_ge_0 (separatrix_form.s X t)); repeat split; refine (f_equal (Rmult _) _);
    unfold descended.sn, descended.cn, descended.dn, separatrix_form.sn, separatrix_form.cn, separatrix_form.dn;
    cbn -[pow]; unfold separatrix_form.k_1, separatrix_form.d; field; lra.
Qed.

Theorem descended_motion X : descended.holds X ->
  moves (descended.epsilon X) (descended.c_a X) (descended.c_b X) (descended.c_d X)
    (descended.Omega_a X) (descended.Omega_b X) (descended.Omega_d X)
    (Quaternion (descended.p_0 X) (descended.p_a X) (descended.p_b X) (descended.p_d X))
    (fun t => Quaternion (descended.qbar_0 X t) (descended.qbar_a X t) (descended.qbar_b X t) (descended.qbar_d X t))
    (fun t => Quaternion (descended.q_0 X t) (descended.q_a X t) (descended.q_b X t) (descended.q_d X t)).
Proof.
  intros H; from_ledger (descended.relation_0 X H)
    ltac:(intros t; unfold descended.q_0, descended.q_a, descended.q_b, descended.q_d, product; cbn [part_0 part_a part_b part_d]; f_equal; ring)
    (descended_rates X H) (descended.fact_solution X H).
Qed.

Theorem theta_form_motion X : theta_form.holds X ->
  moves (theta_form.epsilon X) (theta_form.c_a X) (theta_form.c_b X) (theta_form.c_d X)
    (theta_form.Omega_a X) (theta_form.Omega_b X) (theta_form.Omega_d X)
    (Quaternion (theta_form.p_0 X) (theta_form.p_a X) (theta_form.p_b X) (theta_form.p_d X))
    (fun t => Quaternion (theta_form.qbar_0 X t) (theta_form.qbar_a X t) (theta_form.qbar_b X t) (theta_form.qbar_d X t))
    (fun t => Quaternion (theta_form.q_0 X t) (theta_form.q_a X t) (theta_form.q_b X t) (theta_form.q_d X t)).
Proof.
  intros H; from_ledger (theta_form.relation_0 X H)
    ltac:(intros t; unfold theta_form.q_0, theta_form.q_a, theta_form.q_b, theta_form.q_d, product; cbn [part_0 part_a part_b part_d]; f_equal; ring)
    (descended_rates _ (theta_form.models_descended X H)) (theta_form.fact_solution X H).
Qed.

Theorem symmetric_form_motion X : symmetric_form.holds X ->
  moves (symmetric_form.epsilon X) (symmetric_form.c_a X) (symmetric_form.c_b X) (symmetric_form.c_d X)
    (symmetric_form.Omega_a X) (symmetric_form.Omega_b X) (symmetric_form.Omega_d X)
    (Quaternion (symmetric_form.p_0 X) (symmetric_form.p_a X) (symmetric_form.p_b X) (symmetric_form.p_d X))
    (fun t => Quaternion (symmetric_form.qbar_0 X t) (symmetric_form.qbar_a X t) (symmetric_form.qbar_b X t) (symmetric_form.qbar_d X t))
    (fun t => Quaternion (symmetric_form.q_0 X t) (symmetric_form.q_a X t) (symmetric_form.q_b X t) (symmetric_form.q_d X t)).
Proof.
  intros H; from_ledger (symmetric_form.relation_0 X H)
    ltac:(intros t; unfold symmetric_form.q_0, symmetric_form.q_a, symmetric_form.q_b, symmetric_form.q_d, product; cbn [part_0 part_a part_b part_d]; f_equal; ring)
    (symmetric_rates X H) (symmetric_form.fact_solution X H).
Qed.

Theorem hyperbolic_form_motion X : hyperbolic_form.holds X ->
  moves (hyperbolic_form.epsilon X) (hyperbolic_form.c_a X) (hyperbolic_form.c_b X) (hyperbolic_form.c_d X)
    (hyperbolic_form.Omega_a X) (hyperbolic_form.Omega_b X) (hyperbolic_form.Omega_d X)
    (Quaternion (hyperbolic_form.p_0 X) (hyperbolic_form.p_a X) (hyperbolic_form.p_b X) (hyperbolic_form.p_d X))
    (fun t => Quaternion (hyperbolic_form.qbar_0 X t) (hyperbolic_form.qbar_a X t) (hyperbolic_form.qbar_b X t) (hyperbolic_form.qbar_d X t))
    (fun t => Quaternion (hyperbolic_form.q_0 X t) (hyperbolic_form.q_a X t) (hyperbolic_form.q_b X t) (hyperbolic_form.q_d X t)).
Proof.
  intros H; from_ledger (hyperbolic_form.relation_0 X H)
    ltac:(intros t; unfold hyperbolic_form.q_0, hyperbolic_form.q_a, hyperbolic_form.q_b, hyperbolic_form.q_d, product; cbn [part_0 part_a part_b part_d]; f_equal; ring)
    (descended_rates _ (theta_form.models_descended _ (hyperbolic_form.models_theta_form X H))) (hyperbolic_form.fact_solution X H).
Qed.

Theorem separatrix_form_motion X : separatrix_form.holds X ->
  moves (separatrix_form.epsilon X) (separatrix_form.c_a X) (separatrix_form.c_b X) (separatrix_form.c_d X)
    (separatrix_form.Omega_a X) (separatrix_form.Omega_b X) (separatrix_form.Omega_d X)
    (Quaternion (separatrix_form.p_0 X) (separatrix_form.p_a X) (separatrix_form.p_b X) (separatrix_form.p_d X))
    (fun t => Quaternion (separatrix_form.qbar_0 X t) (separatrix_form.qbar_a X t) (separatrix_form.qbar_b X t) (separatrix_form.qbar_d X t))
    (fun t => Quaternion (separatrix_form.q_0 X t) (separatrix_form.q_a X t) (separatrix_form.q_b X t) (separatrix_form.q_d X t)).
Proof.
  intros H; from_ledger (separatrix_form.relation_0 X H)
    ltac:(intros t; unfold separatrix_form.q_0, separatrix_form.q_a, separatrix_form.q_b, separatrix_form.q_d, product; cbn [part_0 part_a part_b part_d]; f_equal; ring)
    (separatrix_rates X H) (separatrix_form.fact_solution X H).
Qed.

Theorem pi_near_motion X : pi_near.holds X ->
  moves (pi_near.epsilon X) (pi_near.c_a X) (pi_near.c_b X) (pi_near.c_d X)
    (pi_near.Omega_a X) (pi_near.Omega_b X) (pi_near.Omega_d X)
    (Quaternion (pi_near.p_0 X) (pi_near.p_a X) (pi_near.p_b X) (pi_near.p_d X))
    (fun t => Quaternion (pi_near.qbar_0 X t) (pi_near.qbar_a X t) (pi_near.qbar_b X t) (pi_near.qbar_d X t))
    (fun t => Quaternion (pi_near.q_0 X t) (pi_near.q_a X t) (pi_near.q_b X t) (pi_near.q_d X t)).
Proof.
  intros H; from_ledger (pi_near.relation_0 X H)
    ltac:(intros t; unfold pi_near.q_0, pi_near.q_a, pi_near.q_b, pi_near.q_d, product; cbn [part_0 part_a part_b part_d]; f_equal; ring)
    (descended_rates _ (pi_near.models_descended X H)) (pi_near.fact_solution X H).
Qed.

Theorem pi_far_motion X : pi_far.holds X ->
  moves (pi_far.epsilon X) (pi_far.c_a X) (pi_far.c_b X) (pi_far.c_d X)
    (pi_far.Omega_a X) (pi_far.Omega_b X) (pi_far.Omega_d X)
    (Quaternion (pi_far.p_0 X) (pi_far.p_a X) (pi_far.p_b X) (pi_far.p_d X))
    (fun t => Quaternion (pi_far.qbar_0 X t) (pi_far.qbar_a X t) (pi_far.qbar_b X t) (pi_far.qbar_d X t))
    (fun t => Quaternion (pi_far.q_0 X t) (pi_far.q_a X t) (pi_far.q_b X t) (pi_far.q_d X t)).
Proof.
  intros H; from_ledger (pi_far.relation_0 X H)
    ltac:(intros t; unfold pi_far.q_0, pi_far.q_a, pi_far.q_b, pi_far.q_d, product; cbn [part_0 part_a part_b part_d]; f_equal; ring)
    (descended_rates _ (pi_far.models_descended X H)) (pi_far.fact_solution X H).
Qed.
