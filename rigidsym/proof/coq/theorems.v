(* What is proved, in plain words.  Nothing below speaks of a ledger: real numbers, real functions of
   time and their derivatives.  Body axes are a, b, d; h = 1 when they are right-handed, h = -1 when
   not.  Moments of inertia are c_a, c_b, c_d, body rates w_a, w_b, w_d, and the attitude is the
   quaternion (q_0; q_a, q_b, q_d), body to inertial. *)
From Rigidsym Require Import prelude.

Definition euler (h c_a c_b c_d : R) (w_a w_b w_d : R -> R) : Prop := forall t,
  is_derive w_a t (h * (c_b - c_d) / c_a * w_b t * w_d t) /\
  is_derive w_b t (h * (c_d - c_a) / c_b * w_d t * w_a t) /\
  is_derive w_d t (h * (c_a - c_b) / c_d * w_a t * w_b t).

Definition kinematics (h : R) (w_a w_b w_d q_0 q_a q_b q_d : R -> R) : Prop := forall t,
  is_derive q_0 t ((- q_a t * w_a t - q_b t * w_b t - q_d t * w_d t) / 2) /\
  is_derive q_a t ((q_0 t * w_a t + h * (q_b t * w_d t - q_d t * w_b t)) / 2) /\
  is_derive q_b t ((q_0 t * w_b t + h * (q_d t * w_a t - q_a t * w_d t)) / 2) /\
  is_derive q_d t ((q_0 t * w_d t + h * (q_a t * w_b t - q_b t * w_a t)) / 2).

Lemma turned (f : R -> R) (t u v : R) : @eq R u v -> is_derive f t u -> is_derive f t v.
Proof. now intros ->. Qed.

(* A function whose derivative vanishes is constant. *)
Lemma constant_in_time (f : R -> R) : (forall t, is_derive f t 0) -> forall t, f t = f 0.
Proof.
  intros D t. destruct (MVT_gen f 0 t (fun _ => 0)) as (c & _ & E).
  - intros; apply D.
  - intros x _; apply continuity_pt_filterlim, (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule)); exists 0; apply D.
  - lra.
Qed.

(* * Steady motion: rates that do not change, because M and Omega are parallel. *)

Theorem steady_motion (c_a c_b c_d w_a w_b w_d p_0 p_a p_b p_d : R) :
  0 < c_a -> 0 < c_b -> 0 < c_d ->
  (c_b - c_d) * w_b * w_d = 0 -> (c_d - c_a) * w_d * w_a = 0 -> (c_a - c_b) * w_a * w_b = 0 ->
  0 < w_a ^ 2 + w_b ^ 2 + w_d ^ 2 ->
  let w := sqrt (w_a ^ 2 + w_b ^ 2 + w_d ^ 2) in
  let cosine t := cos (w * t / 2) in
  let sine t := sin (w * t / 2) / w in
  let q_0 t := p_0 * cosine t - (p_a * w_a + p_b * w_b + p_d * w_d) * sine t in
  let q_a t := p_a * cosine t + (p_0 * w_a + p_b * w_d - p_d * w_b) * sine t in
  let q_b t := p_b * cosine t + (p_0 * w_b + p_d * w_a - p_a * w_d) * sine t in
  let q_d t := p_d * cosine t + (p_0 * w_d + p_a * w_b - p_b * w_a) * sine t in
  euler 1 c_a c_b c_d (fun _ => w_a) (fun _ => w_b) (fun _ => w_d) /\
  kinematics 1 (fun _ => w_a) (fun _ => w_b) (fun _ => w_d) q_0 q_a q_b q_d /\
  q_0 0 = p_0 /\ q_a 0 = p_a /\ q_b 0 = p_b /\ q_d 0 = p_d.
Proof.
  intros Ca Cb Cd Ea Eb Ed W w cosine sine q_0 q_a q_b q_d.
  assert (S : w ^ 2 = w_a ^ 2 + w_b ^ 2 + w_d ^ 2) by (apply pow2_sqrt; lra).
  assert (N : w <> 0) by (intros Z; rewrite Z in S; cbn in S; lra).
  split; [intros t; refine (conj _ (conj _ _)) | split;
    [intros t; refine (conj _ (conj _ (conj _ _))) | refine (conj _ (conj _ (conj _ _)))]].
  1-3: apply (turned _ _ 0); [|apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule))].
  1: replace (1 * (c_b - c_d) / c_a * w_b * w_d) with ((c_b - c_d) * w_b * w_d / c_a) by (field; lra); rewrite Ea; field; lra.
  1: replace (1 * (c_d - c_a) / c_b * w_d * w_a) with ((c_d - c_a) * w_d * w_a / c_b) by (field; lra); rewrite Eb; field; lra.
  1: replace (1 * (c_a - c_b) / c_d * w_a * w_b) with ((c_a - c_b) * w_a * w_b / c_d) by (field; lra); rewrite Ed; field; lra.
  5-8: unfold q_0, q_a, q_b, q_d, cosine, sine; replace (w * 0 / 2) with 0 by field.
  5-8: rewrite cos_0, sin_0; field; exact N.
  all: unfold q_0, q_a, q_b, q_d, cosine, sine; auto_derive; [easy|].
  all: change (w * t * / 2) with (w * t / 2).
  all: apply (Rmult_eq_reg_r w); [|exact N]; field_simplify; [|exact N..]; rewrite ?S; field; exact N.
Qed.
