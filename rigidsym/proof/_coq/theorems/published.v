(* What generated code evaluates: the forms that the ledger publishes are the motion, each under what
   the context of its name supposes (its record `holds`), and of a body with positive moments.

   Start: the body starts where these functions do.  That they start at given rates and attitude, the
   ledger's `rates_start` and `attitude_start` tell. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Rigidsym.theorems Require Import motion.
From Rigidsym.contexts Require descended theta_form hyperbolic_form separatrix_form symmetric_form pi_near pi_far.
Open Scope R_scope.

(* The motion from where it is at t = 0. *)
Definition moves (h c_a c_b c_d : R) (w_a w_b w_d q_0 q_a q_b q_d : R -> R) : Prop :=
  let q t := Quaternion (q_0 t) (q_a t) (q_b t) (q_d t) in
  0 < c_a -> 0 < c_b -> 0 < c_d ->
  (forall t, norm_squared (q t) = 1) /\
  the_motion h c_a c_b c_d (w_a 0) (w_b 0) (w_d 0) (q 0) w_a w_b w_d q.

(* The equations as the ledger writes them. *)
Lemma as_in_ledger h c_a c_b c_d w_a w_b w_d q_0 q_a q_b q_d :
  euler h c_a c_b c_d w_a w_b w_d ->
  (forall t, q_0 t ^ 2 + q_a t ^ 2 + q_b t ^ 2 + q_d t ^ 2 = 1 /\
    is_derive q_0 t (- w_a t * q_a t / 2 - w_b t * q_b t / 2 - w_d t * q_d t / 2) /\
    is_derive q_a t (w_a t * q_0 t / 2 + h * (- w_b t * q_d t + w_d t * q_b t) / 2) /\
    is_derive q_b t (w_b t * q_0 t / 2 + h * (w_a t * q_d t - w_d t * q_a t) / 2) /\
    is_derive q_d t (w_d t * q_0 t / 2 + h * (- w_a t * q_b t + w_b t * q_a t) / 2)) ->
  moves h c_a c_b c_d w_a w_b w_d q_0 q_a q_b q_d.
Proof.
  unfold moves; intros E Q Ca Cb Cd; split; [intros t; apply (Q t)|].
  apply unique; trivial; constructor; trivial; intros t; destruct (Q t) as (_ & D0 & Da & Db & Dd).
  refine (conj _ (conj _ (conj _ _)));
    [refine (derive_as _ _ _ _ D0 _) | refine (derive_as _ _ _ _ Da _) | refine (derive_as _ _ _ _ Db _)
    | refine (derive_as _ _ _ _ Dd _)]; cbn; field.
Qed.

Theorem descended_motion X : descended.holds X ->
  moves (descended.epsilon X) (descended.c_a X) (descended.c_b X) (descended.c_d X)
    (descended.Omega_a X) (descended.Omega_b X) (descended.Omega_d X)
    (descended.q_0 X) (descended.q_a X) (descended.q_b X) (descended.q_d X).
Proof.
  intros H; exact (as_in_ledger _ _ _ _ _ _ _ _ _ _ _
    (descended.fact_euler X H) (descended.fact_solution X H)).
Qed.

Theorem theta_form_motion X : theta_form.holds X ->
  moves (theta_form.epsilon X) (theta_form.c_a X) (theta_form.c_b X) (theta_form.c_d X)
    (theta_form.Omega_a X) (theta_form.Omega_b X) (theta_form.Omega_d X)
    (theta_form.q_0 X) (theta_form.q_a X) (theta_form.q_b X) (theta_form.q_d X).
Proof.
  intros H; exact (as_in_ledger _ _ _ _ _ _ _ _ _ _ _
    (descended.fact_euler _ (theta_form.models_descended X H)) (theta_form.fact_solution X H)).
Qed.

Theorem symmetric_form_motion X : symmetric_form.holds X ->
  moves (symmetric_form.epsilon X) (symmetric_form.c_a X) (symmetric_form.c_b X) (symmetric_form.c_d X)
    (symmetric_form.Omega_a X) (symmetric_form.Omega_b X) (symmetric_form.Omega_d X)
    (symmetric_form.q_0 X) (symmetric_form.q_a X) (symmetric_form.q_b X) (symmetric_form.q_d X).
Proof.
  intros H; exact (as_in_ledger _ _ _ _ _ _ _ _ _ _ _
    (descended.fact_euler _ (symmetric_form.models_descended X H)) (symmetric_form.fact_solution X H)).
Qed.

Theorem hyperbolic_form_motion X : hyperbolic_form.holds X ->
  moves (hyperbolic_form.epsilon X) (hyperbolic_form.c_a X) (hyperbolic_form.c_b X) (hyperbolic_form.c_d X)
    (hyperbolic_form.Omega_a X) (hyperbolic_form.Omega_b X) (hyperbolic_form.Omega_d X)
    (hyperbolic_form.q_0 X) (hyperbolic_form.q_a X) (hyperbolic_form.q_b X) (hyperbolic_form.q_d X).
Proof.
  intros H; exact (as_in_ledger _ _ _ _ _ _ _ _ _ _ _
    (descended.fact_euler _ (theta_form.models_descended _ (hyperbolic_form.models_theta_form X H)))
    (hyperbolic_form.fact_solution X H)).
Qed.

Theorem separatrix_form_motion X : separatrix_form.holds X ->
  moves (separatrix_form.epsilon X) (separatrix_form.c_a X) (separatrix_form.c_b X) (separatrix_form.c_d X)
    (separatrix_form.Omega_a X) (separatrix_form.Omega_b X) (separatrix_form.Omega_d X)
    (separatrix_form.q_0 X) (separatrix_form.q_a X) (separatrix_form.q_b X) (separatrix_form.q_d X).
Proof.
  intros H; exact (as_in_ledger _ _ _ _ _ _ _ _ _ _ _
    (descended.fact_euler _ (theta_form.models_descended _ (separatrix_form.models_theta_form X H)))
    (separatrix_form.fact_solution X H)).
Qed.

Theorem pi_near_motion X : pi_near.holds X ->
  moves (pi_near.epsilon X) (pi_near.c_a X) (pi_near.c_b X) (pi_near.c_d X)
    (pi_near.Omega_a X) (pi_near.Omega_b X) (pi_near.Omega_d X)
    (pi_near.q_0 X) (pi_near.q_a X) (pi_near.q_b X) (pi_near.q_d X).
Proof.
  intros H; exact (as_in_ledger _ _ _ _ _ _ _ _ _ _ _
    (descended.fact_euler _ (pi_near.models_descended X H)) (pi_near.fact_solution X H)).
Qed.

Theorem pi_far_motion X : pi_far.holds X ->
  moves (pi_far.epsilon X) (pi_far.c_a X) (pi_far.c_b X) (pi_far.c_d X)
    (pi_far.Omega_a X) (pi_far.Omega_b X) (pi_far.Omega_d X)
    (pi_far.q_0 X) (pi_far.q_a X) (pi_far.q_b X) (pi_far.q_d X).
Proof.
  intros H; exact (as_in_ledger _ _ _ _ _ _ _ _ _ _ _
    (descended.fact_euler _ (pi_far.models_descended X H)) (pi_far.fact_solution X H)).
Qed.
