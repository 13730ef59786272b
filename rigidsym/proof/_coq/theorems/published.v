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

(* The equations as the ledger writes them. *)
Lemma as_in_ledger h c_a c_b c_d w_a w_b w_d p qbar q :
  h ^ 2 = 1 -> (forall t, q t = product h p (qbar t)) ->
  euler h c_a c_b c_d w_a w_b w_d ->
  (forall t, part_0 (q t) ^ 2 + part_a (q t) ^ 2 + part_b (q t) ^ 2 + part_d (q t) ^ 2 = 1 /\
    is_derive (fun t => part_0 (q t)) t
      (- w_a t * part_a (q t) / 2 - w_b t * part_b (q t) / 2 - w_d t * part_d (q t) / 2) /\
    is_derive (fun t => part_a (q t)) t
      (w_a t * part_0 (q t) / 2 + h * (- w_b t * part_d (q t) + w_d t * part_b (q t)) / 2) /\
    is_derive (fun t => part_b (q t)) t
      (w_b t * part_0 (q t) / 2 + h * (w_a t * part_d (q t) - w_d t * part_a (q t)) / 2) /\
    is_derive (fun t => part_d (q t)) t
      (w_d t * part_0 (q t) / 2 + h * (- w_a t * part_b (q t) + w_b t * part_a (q t)) / 2)) ->
  moves h c_a c_b c_d w_a w_b w_d p qbar q.
Proof.
  unfold moves; intros H F E Q Ca Cb Cd; split; [intros t; apply (Q t)|]; intros start S P.
  assert (N : norm_squared (qbar 0) = 1).
  { pose proof (proj1 (Q 0)) as N; fold (norm_squared (q 0)) in N.
    rewrite F, norm_of_product, P, norm_of_product, norm_of_conjugate, S in N by exact H.
    pose proof (pow2_ge_0 (part_0 (qbar 0))); pose proof (pow2_ge_0 (part_a (qbar 0)));
      pose proof (pow2_ge_0 (part_b (qbar 0))); pose proof (pow2_ge_0 (part_d (qbar 0))).
    assert (0 <= norm_squared (qbar 0)) by (unfold norm_squared; lra).
    set (n := norm_squared (qbar 0)) in *; clearbody n; nra. }
  apply unique; trivial; constructor; trivial.
  - intros t; destruct (Q t) as (_ & D0 & Da & Db & Dd).
    refine (conj _ (conj _ (conj _ _)));
      [refine (derive_as _ _ _ _ D0 _) | refine (derive_as _ _ _ _ Da _) | refine (derive_as _ _ _ _ Db _)
      | refine (derive_as _ _ _ _ Dd _)]; cbn; field.
  - rewrite F, P; exact (from_start_at_start h start qbar H N).
Qed.

(* A sign, as the ledger supposes it; and its quaternion in front, as it writes the product. *)
Lemma sign_of h : h ^ 2 - 1 = 0 -> h ^ 2 = 1.
Proof. lra. Qed.

Theorem descended_motion X : descended.holds X ->
  moves (descended.epsilon X) (descended.c_a X) (descended.c_b X) (descended.c_d X)
    (descended.Omega_a X) (descended.Omega_b X) (descended.Omega_d X)
    (Quaternion (descended.p_0 X) (descended.p_a X) (descended.p_b X) (descended.p_d X))
    (fun t => Quaternion (descended.qbar_0 X t) (descended.qbar_a X t) (descended.qbar_b X t) (descended.qbar_d X t))
    (fun t => Quaternion (descended.q_0 X t) (descended.q_a X t) (descended.q_b X t) (descended.q_d X t)).
Proof.
  intros H; apply as_in_ledger; [exact (sign_of _ (descended.relation_0 X H)) | |
    exact (descended.fact_euler X H) | exact (descended.fact_solution X H)].
  intros t; unfold descended.q_0, descended.q_a, descended.q_b, descended.q_d, product; cbn [part_0 part_a part_b part_d].
  f_equal; ring.
Qed.

Theorem theta_form_motion X : theta_form.holds X ->
  moves (theta_form.epsilon X) (theta_form.c_a X) (theta_form.c_b X) (theta_form.c_d X)
    (theta_form.Omega_a X) (theta_form.Omega_b X) (theta_form.Omega_d X)
    (Quaternion (theta_form.p_0 X) (theta_form.p_a X) (theta_form.p_b X) (theta_form.p_d X))
    (fun t => Quaternion (theta_form.qbar_0 X t) (theta_form.qbar_a X t) (theta_form.qbar_b X t) (theta_form.qbar_d X t))
    (fun t => Quaternion (theta_form.q_0 X t) (theta_form.q_a X t) (theta_form.q_b X t) (theta_form.q_d X t)).
Proof.
  intros H; apply as_in_ledger; [exact (sign_of _ (theta_form.relation_0 X H)) | |
    exact (descended.fact_euler _ (theta_form.models_descended X H)) | exact (theta_form.fact_solution X H)].
  intros t; unfold theta_form.q_0, theta_form.q_a, theta_form.q_b, theta_form.q_d, product; cbn [part_0 part_a part_b part_d].
  f_equal; ring.
Qed.

Theorem symmetric_form_motion X : symmetric_form.holds X ->
  moves (symmetric_form.epsilon X) (symmetric_form.c_a X) (symmetric_form.c_b X) (symmetric_form.c_d X)
    (symmetric_form.Omega_a X) (symmetric_form.Omega_b X) (symmetric_form.Omega_d X)
    (Quaternion (symmetric_form.p_0 X) (symmetric_form.p_a X) (symmetric_form.p_b X) (symmetric_form.p_d X))
    (fun t => Quaternion (symmetric_form.qbar_0 X t) (symmetric_form.qbar_a X t) (symmetric_form.qbar_b X t) (symmetric_form.qbar_d X t))
    (fun t => Quaternion (symmetric_form.q_0 X t) (symmetric_form.q_a X t) (symmetric_form.q_b X t) (symmetric_form.q_d X t)).
Proof.
  intros H; apply as_in_ledger; [exact (sign_of _ (symmetric_form.relation_0 X H)) | |
    exact (descended.fact_euler _ (symmetric_form.models_descended X H)) | exact (symmetric_form.fact_solution X H)].
  intros t; unfold symmetric_form.q_0, symmetric_form.q_a, symmetric_form.q_b, symmetric_form.q_d, product; cbn [part_0 part_a part_b part_d].
  f_equal; ring.
Qed.

Theorem hyperbolic_form_motion X : hyperbolic_form.holds X ->
  moves (hyperbolic_form.epsilon X) (hyperbolic_form.c_a X) (hyperbolic_form.c_b X) (hyperbolic_form.c_d X)
    (hyperbolic_form.Omega_a X) (hyperbolic_form.Omega_b X) (hyperbolic_form.Omega_d X)
    (Quaternion (hyperbolic_form.p_0 X) (hyperbolic_form.p_a X) (hyperbolic_form.p_b X) (hyperbolic_form.p_d X))
    (fun t => Quaternion (hyperbolic_form.qbar_0 X t) (hyperbolic_form.qbar_a X t) (hyperbolic_form.qbar_b X t) (hyperbolic_form.qbar_d X t))
    (fun t => Quaternion (hyperbolic_form.q_0 X t) (hyperbolic_form.q_a X t) (hyperbolic_form.q_b X t) (hyperbolic_form.q_d X t)).
Proof.
  intros H; apply as_in_ledger; [exact (sign_of _ (hyperbolic_form.relation_0 X H)) | |
    exact (descended.fact_euler _ (theta_form.models_descended _ (hyperbolic_form.models_theta_form X H))) | exact (hyperbolic_form.fact_solution X H)].
  intros t; unfold hyperbolic_form.q_0, hyperbolic_form.q_a, hyperbolic_form.q_b, hyperbolic_form.q_d, product; cbn [part_0 part_a part_b part_d].
  f_equal; ring.
Qed.

Theorem separatrix_form_motion X : separatrix_form.holds X ->
  moves (separatrix_form.epsilon X) (separatrix_form.c_a X) (separatrix_form.c_b X) (separatrix_form.c_d X)
    (separatrix_form.Omega_a X) (separatrix_form.Omega_b X) (separatrix_form.Omega_d X)
    (Quaternion (separatrix_form.p_0 X) (separatrix_form.p_a X) (separatrix_form.p_b X) (separatrix_form.p_d X))
    (fun t => Quaternion (separatrix_form.qbar_0 X t) (separatrix_form.qbar_a X t) (separatrix_form.qbar_b X t) (separatrix_form.qbar_d X t))
    (fun t => Quaternion (separatrix_form.q_0 X t) (separatrix_form.q_a X t) (separatrix_form.q_b X t) (separatrix_form.q_d X t)).
Proof.
  intros H; apply as_in_ledger; [exact (sign_of _ (separatrix_form.relation_0 X H)) | |
    exact (descended.fact_euler _ (theta_form.models_descended _ (separatrix_form.models_theta_form X H))) | exact (separatrix_form.fact_solution X H)].
  intros t; unfold separatrix_form.q_0, separatrix_form.q_a, separatrix_form.q_b, separatrix_form.q_d, product; cbn [part_0 part_a part_b part_d].
  f_equal; ring.
Qed.

Theorem pi_near_motion X : pi_near.holds X ->
  moves (pi_near.epsilon X) (pi_near.c_a X) (pi_near.c_b X) (pi_near.c_d X)
    (pi_near.Omega_a X) (pi_near.Omega_b X) (pi_near.Omega_d X)
    (Quaternion (pi_near.p_0 X) (pi_near.p_a X) (pi_near.p_b X) (pi_near.p_d X))
    (fun t => Quaternion (pi_near.qbar_0 X t) (pi_near.qbar_a X t) (pi_near.qbar_b X t) (pi_near.qbar_d X t))
    (fun t => Quaternion (pi_near.q_0 X t) (pi_near.q_a X t) (pi_near.q_b X t) (pi_near.q_d X t)).
Proof.
  intros H; apply as_in_ledger; [exact (sign_of _ (pi_near.relation_0 X H)) | |
    exact (descended.fact_euler _ (pi_near.models_descended X H)) | exact (pi_near.fact_solution X H)].
  intros t; unfold pi_near.q_0, pi_near.q_a, pi_near.q_b, pi_near.q_d, product; cbn [part_0 part_a part_b part_d].
  f_equal; ring.
Qed.

Theorem pi_far_motion X : pi_far.holds X ->
  moves (pi_far.epsilon X) (pi_far.c_a X) (pi_far.c_b X) (pi_far.c_d X)
    (pi_far.Omega_a X) (pi_far.Omega_b X) (pi_far.Omega_d X)
    (Quaternion (pi_far.p_0 X) (pi_far.p_a X) (pi_far.p_b X) (pi_far.p_d X))
    (fun t => Quaternion (pi_far.qbar_0 X t) (pi_far.qbar_a X t) (pi_far.qbar_b X t) (pi_far.qbar_d X t))
    (fun t => Quaternion (pi_far.q_0 X t) (pi_far.q_a X t) (pi_far.q_b X t) (pi_far.q_d X t)).
Proof.
  intros H; apply as_in_ledger; [exact (sign_of _ (pi_far.relation_0 X H)) | |
    exact (descended.fact_euler _ (pi_far.models_descended X H)) | exact (pi_far.fact_solution X H)].
  intros t; unfold pi_far.q_0, pi_far.q_a, pi_far.q_b, pi_far.q_d, product; cbn [part_0 part_a part_b part_d].
  f_equal; ring.
Qed.
