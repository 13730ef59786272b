(* What a motion is, in plain words, and that there is but one from each start.

   Nothing here speaks of a ledger: real numbers, real functions of time and their derivatives.  Body
   axes are a, b, d; h = 1 where they are right-handed, h = -1 where not.  Moments of inertia are c_a,
   c_b, c_d, body rates w_a, w_b, w_d, and the attitude is a quaternion, body to inertial. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Record quaternion := Quaternion { part_0 : R; part_a : R; part_b : R; part_d : R }.

Definition norm_squared (q : quaternion) : R :=
  part_0 q ^ 2 + part_a q ^ 2 + part_b q ^ 2 + part_d q ^ 2.

Definition conjugate (q : quaternion) : quaternion :=
  Quaternion (part_0 q) (- part_a q) (- part_b q) (- part_d q).

Definition product (h : R) (p q : quaternion) : quaternion :=
  Quaternion
    (part_0 p * part_0 q - part_a p * part_a q - part_b p * part_b q - part_d p * part_d q)
    (part_0 p * part_a q + part_a p * part_0 q + h * (part_b p * part_d q - part_d p * part_b q))
    (part_0 p * part_b q + part_b p * part_0 q + h * (part_d p * part_a q - part_a p * part_d q))
    (part_0 p * part_d q + part_d p * part_0 q + h * (part_a p * part_b q - part_b p * part_a q)).

(* Euler's equations without torque. *)
Definition euler (h c_a c_b c_d : R) (w_a w_b w_d : R -> R) : Prop := forall t,
  is_derive w_a t (h * (c_b - c_d) / c_a * w_b t * w_d t) /\
  is_derive w_b t (h * (c_d - c_a) / c_b * w_d t * w_a t) /\
  is_derive w_d t (h * (c_a - c_b) / c_d * w_a t * w_b t).

(* q' = q (0, w) / 2. *)
Definition kinematics (h : R) (w_a w_b w_d : R -> R) (q : R -> quaternion) : Prop := forall t,
  let rate := product h (q t) (Quaternion 0 (w_a t) (w_b t) (w_d t)) in
  is_derive (fun s => part_0 (q s)) t (part_0 rate / 2) /\
  is_derive (fun s => part_a (q s)) t (part_a rate / 2) /\
  is_derive (fun s => part_b (q s)) t (part_b rate / 2) /\
  is_derive (fun s => part_d (q s)) t (part_d rate / 2).

(* These functions of time obey the equations, and start at rates v and attitude p. *)
Record motion (h c_a c_b c_d v_a v_b v_d : R) (p : quaternion)
    (w_a w_b w_d : R -> R) (q : R -> quaternion) : Prop := Motion {
  motion_rates : euler h c_a c_b c_d w_a w_b w_d;
  motion_attitude : kinematics h w_a w_b w_d q;
  start_a : w_a 0 = v_a;
  start_b : w_b 0 = v_b;
  start_d : w_d 0 = v_d;
  start_attitude : q 0 = p
}.

(* And no other functions do. *)
Definition the_motion (h c_a c_b c_d v_a v_b v_d : R) (p : quaternion)
    (w_a w_b w_d : R -> R) (q : R -> quaternion) : Prop :=
  motion h c_a c_b c_d v_a v_b v_d p w_a w_b w_d q /\
  forall u_a u_b u_d r, motion h c_a c_b c_d v_a v_b v_d p u_a u_b u_d r ->
    forall t, u_a t = w_a t /\ u_b t = w_b t /\ u_d t = w_d t /\ r t = q t.

(* * Derivatives *)

Lemma derive_as (f : R -> R) (t u v : R) : is_derive f t u -> @eq R u v -> is_derive f t v.
Proof. now intros D <-. Qed.

(* Euler's equations, each with its product of rates in any order. *)
Ltac as_euler E := let Da := fresh in let Db := fresh in let Dd := fresh in
  destruct E as (Da & Db & Dd); split; [refine (derive_as _ _ _ _ Da _) | split;
    [refine (derive_as _ _ _ _ Db _) | refine (derive_as _ _ _ _ Dd _)]]; unfold Rdiv; ring.

(* Derivatives of what is made of functions whose derivatives are known. *)
Ltac derive_known :=
  auto_derive; [repeat split; try (eexists; eassumption) |];
  repeat match goal with
  | D : is_derive _ ?t ?l |- context [Derive ?f ?t] => rewrite (is_derive_unique f t l D)
  end.

Lemma derive_squares (f g h k : R -> R) (t df dg dh dk : R) :
  is_derive f t df -> is_derive g t dg -> is_derive h t dh -> is_derive k t dk ->
  is_derive (fun s => f s ^ 2 + g s ^ 2 + h s ^ 2 + k s ^ 2) t
    (2 * (f t * df + g t * dg + h t * dh + k t * dk)).
Proof. intros; derive_known; ring. Qed.

Lemma derive_difference (f g : R -> R) (t df dg : R) :
  is_derive f t df -> is_derive g t dg -> is_derive (fun s => f s - g s) t (df - dg).
Proof. intros; derive_known; ring. Qed.

Lemma between (f df : R -> R) (x y : R) : (forall t, is_derive f t (df t)) ->
  exists c, Rmin x y <= c <= Rmax x y /\ f y - f x = df c * (y - x).
Proof.
  intros D; destruct (MVT_gen f x y df) as (c & I & E).
  - intros; apply D.
  - intros z _; apply continuity_pt_filterlim.
    now apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule)); exists (df z).
  - now exists c.
Qed.

Lemma constant_in_time (f : R -> R) : (forall t, is_derive f t 0) -> forall t, f t = f 0.
Proof. intros D t; destruct (between f (fun _ => 0) 0 t D) as (c & _ & E); lra. Qed.

Lemma not_rising (f df : R -> R) : (forall t, is_derive f t (df t)) -> (forall t, df t <= 0) ->
  forall x y, x <= y -> f y <= f x.
Proof.
  intros D S x y L; destruct (between f df x y D) as (c & _ & E); specialize (S c); nra.
Qed.

(* Groenwall: what is not negative, starts at 0 and changes no faster than in proportion stays 0. *)
Lemma stays_zero (e de : R -> R) (k : R) :
  (forall t, is_derive e t (de t)) -> (forall t, Rabs (de t) <= k * e t) ->
  (forall t, 0 <= e t) -> e 0 = 0 -> forall t, e t = 0.
Proof.
  intros D B P Z t.
  assert (G : forall s, s = 1 \/ s = -1 -> 0 <= s * t -> e t * exp (- k * s * t) <= 0).
  { intros s S T.
    assert (F : forall x, is_derive (fun x => e (s * x) * exp (- k * x)) x
      ((s * de (s * x) - k * e (s * x)) * exp (- k * x))).
    { intros x. assert (C : is_derive (fun x => e (s * x)) x (s * de (s * x)))
        by (apply (is_derive_comp e (fun x => s * x)); [apply D | auto_derive; [easy | ring]]).
      eapply derive_as; [apply (is_derive_mult (fun x => e (s * x)) (fun x => exp (- k * x)));
        [exact C | auto_derive; [easy | reflexivity] | apply Rmult_comm] |].
      unfold plus, mult; cbn; ring. }
    replace (e t * _) with (e (s * (s * t)) * exp (- k * (s * t))) by
      (replace (s * (s * t)) with t by (destruct S as [-> | ->]; ring); f_equal; f_equal; ring).
    replace 0 with (e (s * 0) * exp (- k * 0)) by (rewrite !Rmult_0_r, Z; ring).
    refine (not_rising _ _ F _ 0 (s * t) T); intros x.
    pose proof (exp_pos (- k * x)); pose proof (B (s * x)) as Bx.
    assert (s * de (s * x) <= k * e (s * x))
      by (unfold Rabs in Bx; destruct Rcase_abs, S as [-> | ->]; lra).
    nra. }
  destruct (Rle_dec 0 t) as [L|L].
  - specialize (G 1 (or_introl eq_refl) ltac:(lra)).
    pose proof (exp_pos (- k * 1 * t)); specialize (P t); nra.
  - specialize (G (-1) (or_intror eq_refl) ltac:(lra)).
    pose proof (exp_pos (- k * -1 * t)); specialize (P t); nra.
Qed.

(* * Uniqueness *)

Section Motions.
  Variables (h c_a c_b c_d : R) (Ca : 0 < c_a) (Cb : 0 < c_b) (Cd : 0 < c_d).

  Section Kept.
    Variables (w_a w_b w_d : R -> R) (E : euler h c_a c_b c_d w_a w_b w_d).

    Lemma energy_kept t : c_a * w_a t ^ 2 + c_b * w_b t ^ 2 + c_d * w_d t ^ 2 =
      c_a * w_a 0 ^ 2 + c_b * w_b 0 ^ 2 + c_d * w_d 0 ^ 2.
    Proof.
      apply (constant_in_time (fun t => c_a * w_a t ^ 2 + c_b * w_b t ^ 2 + c_d * w_d t ^ 2)).
      intros x; destruct (E x) as (Da & Db & Dd).
      derive_known; field; lra.
    Qed.

    Lemma momentum_kept t : (c_a * w_a t) ^ 2 + (c_b * w_b t) ^ 2 + (c_d * w_d t) ^ 2 =
      (c_a * w_a 0) ^ 2 + (c_b * w_b 0) ^ 2 + (c_d * w_d 0) ^ 2.
    Proof.
      apply (constant_in_time (fun t => (c_a * w_a t) ^ 2 + (c_b * w_b t) ^ 2 + (c_d * w_d t) ^ 2)).
      intros x; destruct (E x) as (Da & Db & Dd).
      derive_known; field; lra.
    Qed.
  End Kept.

  Lemma norm_kept w_a w_b w_d q : kinematics h w_a w_b w_d q ->
    forall t, norm_squared (q t) = norm_squared (q 0).
  Proof.
    intros E t; apply (constant_in_time (fun t => norm_squared (q t))); unfold norm_squared.
    intros x; destruct (E x) as (D0 & Da & Db & Dd); cbn in *.
    eapply derive_as; [exact (derive_squares _ _ _ _ _ _ _ _ _ D0 Da Db Dd) | cbv beta; field].
  Qed.

  (* Rates are bounded, by their energy. *)
  Definition bound (v_a v_b v_d : R) : R :=
    let energy := c_a * v_a ^ 2 + c_b * v_b ^ 2 + c_d * v_d ^ 2 in
    1 + energy / c_a + energy / c_b + energy / c_d.

  Lemma root_bound c x s : 0 < c -> c * x ^ 2 <= s -> Rabs x <= 1 + s / c.
  Proof.
    intros C L; assert (x ^ 2 <= s / c).
    { apply (Rmult_le_reg_l c); [exact C|]. replace (c * (s / c)) with s by (field; lra); exact L. }
    apply Rabs_le; nra.
  Qed.

  Lemma rates_bounded w_a w_b w_d t : euler h c_a c_b c_d w_a w_b w_d ->
    let B := bound (w_a 0) (w_b 0) (w_d 0) in
    Rabs (w_a t) <= B /\ Rabs (w_b t) <= B /\ Rabs (w_d t) <= B.
  Proof.
    intros E; pose proof (energy_kept w_a w_b w_d E t) as K; unfold bound; cbn [Rabs].
    set (s := c_a * w_a 0 ^ 2 + _ + _) in *.
    assert (P : forall c x, 0 < c -> 0 <= c * x ^ 2)
      by (intros; apply Rmult_le_pos; [lra | apply pow2_ge_0]).
    pose proof (P _ (w_a t) Ca); pose proof (P _ (w_b t) Cb); pose proof (P _ (w_d t) Cd).
    assert (Q : forall c, 0 < c -> 0 <= s / c) by
      (intros; apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]).
    pose proof (Q _ Ca); pose proof (Q _ Cb); pose proof (Q _ Cd).
    pose proof (root_bound c_a (w_a t) s Ca); pose proof (root_bound c_b (w_b t) s Cb);
      pose proof (root_bound c_d (w_d t) s Cd).
    lra.
  Qed.

  (* One term of the rate at which two motions part. *)
  Lemma term_bound k x y w B e :
    Rabs w <= B -> x ^ 2 <= e -> y ^ 2 <= e -> Rabs (k * (x * y * w)) <= Rabs k * (B * e).
  Proof.
    intros W X Y; rewrite Rabs_mult; apply Rmult_le_compat_l; [apply Rabs_pos|].
    rewrite Rabs_mult, Rmult_comm; apply Rmult_le_compat; try apply Rabs_pos; [exact W|].
    apply Rabs_le; nra.
  Qed.

  Lemma rates_unique w_a w_b w_d u_a u_b u_d :
    euler h c_a c_b c_d w_a w_b w_d -> euler h c_a c_b c_d u_a u_b u_d ->
    u_a 0 = w_a 0 -> u_b 0 = w_b 0 -> u_d 0 = w_d 0 ->
    forall t, u_a t = w_a t /\ u_b t = w_b t /\ u_d t = w_d t.
  Proof.
    intros W U Sa Sb Sd.
    set (k_a := h * (c_b - c_d) / c_a); set (k_b := h * (c_d - c_a) / c_b);
      set (k_d := h * (c_a - c_b) / c_d).
    set (x t := u_a t - w_a t); set (y t := u_b t - w_b t); set (z t := u_d t - w_d t).
    set (e t := x t ^ 2 + y t ^ 2 + z t ^ 2).
    set (de t := 2 * (k_a * (x t * y t * w_d t) + k_a * (x t * z t * u_b t)
      + k_b * (y t * z t * w_a t) + k_b * (x t * y t * u_d t)
      + k_d * (x t * z t * w_b t) + k_d * (y t * z t * u_a t))).
    set (B := bound (w_a 0) (w_b 0) (w_d 0)).
    assert (Z : forall t, e t = 0).
    { apply (stays_zero e de (4 * (Rabs k_a + Rabs k_b + Rabs k_d) * B)); intros.
      - destruct (W t) as (? & ? & ?), (U t) as (? & ? & ?).
        unfold e, de, x, y, z, k_a, k_b, k_d; derive_known; field; lra.
      - destruct (rates_bounded w_a w_b w_d t W) as (Wa & Wb & Wd).
        pose proof (rates_bounded u_a u_b u_d t U) as V; rewrite Sa, Sb, Sd in V.
        destruct V as (Ua & Ub & Ud).
        assert (x t ^ 2 <= e t /\ y t ^ 2 <= e t /\ z t ^ 2 <= e t) as (X & Y & Z) by
          (unfold e; pose proof (pow2_ge_0 (x t)); pose proof (pow2_ge_0 (y t));
           pose proof (pow2_ge_0 (z t)); lra).
        assert (T : forall k x y w, Rabs w <= B -> x ^ 2 <= e t -> y ^ 2 <= e t ->
          - (Rabs k * (B * e t)) <= k * (x * y * w) <= Rabs k * (B * e t)) by
          (intros; now apply Rabs_le_between, term_bound).
        pose proof (T k_a _ _ _ Wd X Y); pose proof (T k_a _ _ _ Ub X Z);
          pose proof (T k_b _ _ _ Wa Y Z); pose proof (T k_b _ _ _ Ud X Y);
          pose proof (T k_d _ _ _ Wb X Z); pose proof (T k_d _ _ _ Ua Y Z).
        apply Rabs_le_between; unfold de; lra.
      - unfold e; pose proof (pow2_ge_0 (x t)); pose proof (pow2_ge_0 (y t));
          pose proof (pow2_ge_0 (z t)); lra.
      - unfold e, x, y, z; rewrite Sa, Sb, Sd; ring. }
    intros t; specialize (Z t); unfold e in Z.
    pose proof (pow2_ge_0 (x t)); pose proof (pow2_ge_0 (y t)); pose proof (pow2_ge_0 (z t)).
    assert (X : x t ^ 2 = 0 /\ y t ^ 2 = 0 /\ z t ^ 2 = 0) by lra.
    destruct X as (X & Y & V); rewrite <- Rsqr_pow2 in *.
    apply Rsqr_eq_0 in X, Y, V; unfold x, y, z in *; lra.
  Qed.

  (* With the same rates, the difference of two attitudes is turned as they are: its norm is kept. *)
  Lemma attitude_unique w_a w_b w_d q r :
    kinematics h w_a w_b w_d q -> kinematics h w_a w_b w_d r -> r 0 = q 0 ->
    forall t, r t = q t.
  Proof.
    intros Q S Z.
    set (gap t := Quaternion (part_0 (r t) - part_0 (q t)) (part_a (r t) - part_a (q t))
      (part_b (r t) - part_b (q t)) (part_d (r t) - part_d (q t))).
    assert (G : kinematics h w_a w_b w_d gap).
    { intros t; destruct (Q t) as (Q0 & Qa & Qb & Qd), (S t) as (S0 & Sa & Sb & Sd).
      refine (conj _ (conj _ (conj _ _)));
        [pose proof (derive_difference _ _ _ _ _ S0 Q0) as D
        | pose proof (derive_difference _ _ _ _ _ Sa Qa) as D
        | pose proof (derive_difference _ _ _ _ _ Sb Qb) as D
        | pose proof (derive_difference _ _ _ _ _ Sd Qd) as D];
        (eapply derive_as; [exact D | cbn; field]). }
    intros t; pose proof (norm_kept w_a w_b w_d gap G t) as N.
    unfold norm_squared, gap in N; cbn in N; rewrite Z in N.
    destruct (r t) as [r_0 r_a r_b r_d], (q t) as [q_0 q_a q_b q_d]; cbn in N.
    pose proof (Rle_0_sqr (r_0 - q_0)); pose proof (Rle_0_sqr (r_a - q_a));
      pose proof (Rle_0_sqr (r_b - q_b)); pose proof (Rle_0_sqr (r_d - q_d)).
    f_equal; apply Rminus_diag_uniq, Rsqr_eq_0; unfold Rsqr in *; lra.
  Qed.

  Theorem unique v_a v_b v_d p w_a w_b w_d q :
    motion h c_a c_b c_d v_a v_b v_d p w_a w_b w_d q ->
    the_motion h c_a c_b c_d v_a v_b v_d p w_a w_b w_d q.
  Proof.
    intros W; split; [exact W|]; intros u_a u_b u_d r U.
    destruct W as [We Wq Wa Wb Wd W0], U as [Ue Uq Ua Ub Ud U0].
    assert (S : forall t, u_a t = w_a t /\ u_b t = w_b t /\ u_d t = w_d t)
      by (apply rates_unique; trivial; congruence).
    intros t; destruct (S t) as (? & ? & ?); do 3 (split; [assumption|]).
    apply (attitude_unique w_a w_b w_d); [exact Wq | | congruence].
    intros s; destruct (S s) as (A & B & D); destruct (Uq s) as (? & ? & ? & ?).
    rewrite A, B, D in *; cbn; auto.
  Qed.
End Motions.
