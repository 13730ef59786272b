(* The motion by the elapsed time alone: what the contexts `step`, `thirds` and `doubling` of the ledger
   prove, for every body, every start and every time.

   Coq has no elliptic functions.  That X and Y have their derivatives and their start is supposed, and
   nothing else of them. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Rigidsym.theorems Require Import motion pull_back.
From Rigidsym.contexts Require doubling turn step thirds second_half.
Open Scope R_scope.

(* * Derivatives *)

Lemma continuous_in_time (f df : R -> R) : (forall t, is_derive f t (df t)) -> continuity f.
Proof.
  intros D t; apply continuity_pt_filterlim.
  apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule)); now exists (df t).
Qed.

Lemma stays_positive (f df : R -> R) : (forall t, is_derive f t (df t)) -> 0 < f 0 ->
  (forall t, f t <> 0) -> forall t, 0 < f t.
Proof.
  intros D S N t; pose proof (continuous_in_time f df D) as C.
  destruct (Rlt_le_dec 0 (f t)) as [|L]; [assumption | exfalso].
  destruct (Rle_dec 0 t) as [T|T].
  - destruct (IVT_cor f 0 t C T) as (z & _ & Z); [nra | exact (N z Z)].
  - destruct (IVT_cor f t 0 C) as (z & _ & Z); [lra | nra | exact (N z Z)].
Qed.

(* What changes in proportion to itself. *)
Lemma proportional (f a : R -> R) : (forall t, is_derive f t (a t * f t)) -> (forall t, ex_derive a t) ->
  forall t, f t = f 0 * exp (RInt a 0 t).
Proof.
  intros D A t; pose proof (derive_integral a A) as I.
  assert (K : f t * exp (- RInt a 0 t) = f 0 * exp (- RInt a 0 0)).
  { apply (constant_in_time (fun t => f t * exp (- RInt a 0 t))); intros x.
    specialize (D x); specialize (I x); change (RInt a 0 x) with ((RInt a 0) x).
    set (i := RInt a 0) in *; clearbody i; derive_known; ring. }
  rewrite (RInt_point (V := R_CompleteNormedModule) 0 a) in K.
  unfold zero in K; cbn in K; rewrite Ropp_0, exp_0, Rmult_1_r in K.
  rewrite <- K, Rmult_assoc, <- exp_plus, Rplus_opp_l, exp_0; ring.
Qed.

(* * Functions of the elapsed time *)

Record elapsed (e_1 e_2 : R) (X Y : R -> R) : Prop := Elapsed {
  derivative_X : forall t, is_derive X t (Y t);
  derivative_Y : forall t, is_derive Y t (- e_1 * X t + 2 * e_2 * X t ^ 3);
  X_0 : X 0 = 0;
  Y_0 : Y 0 = 1
}.

Section Elapsed.
  (* e_1 = 2 h + gap and e_2 = h^2 for all bodies. *)
  Variables (h gap : R) (H : 0 <= h) (Gap : 0 <= gap).

  Section One.
    Variables (X Y : R -> R) (E : elapsed (2 * h + gap) (h ^ 2) X Y).

    Lemma curve t : Y t ^ 2 = 1 - (2 * h + gap) * X t ^ 2 + h ^ 2 * X t ^ 4.
    Proof.
      cut (Y t ^ 2 + (2 * h + gap) * X t ^ 2 - h ^ 2 * X t ^ 4 = Y 0 ^ 2 + (2 * h + gap)
        * X 0 ^ 2 - h ^ 2 * X 0 ^ 4).
      { rewrite (X_0 _ _ _ _ E), (Y_0 _ _ _ _ E); lra. }
      apply (constant_in_time (fun t => Y t ^ 2 + (2 * h + gap) * X t ^ 2 - h ^ 2 * X t ^ 4)); intros x.
      destruct E as [DX DY _ _]; specialize (DX x); specialize (DY x); derive_known; ring.
    Qed.

    Let g t := 1 - h * X t ^ 2.
    Lemma derive_g t : is_derive g t (- 2 * h * X t * Y t).
    Proof. pose proof (derivative_X _ _ _ _ E t); unfold g; derive_known; ring. Qed.

    Lemma never_zero t : g t <> 0.
    Proof.
      intros Z; pose proof (curve t) as C.
      assert (S : Y t ^ 2 = g t ^ 2 - gap * X t ^ 2) by (rewrite C; unfold g; ring).
      rewrite Z in S; pose proof (pow2_ge_0 (Y t)).
      destruct (Rle_lt_or_eq_dec _ _ Gap) as [P|P].
      - assert (X2 : X t ^ 2 = 0) by (pose proof (pow2_ge_0 (X t)); nra).
        unfold g in Z; rewrite X2 in Z; lra.
      - (* On the separatrix Y is g. *)
        assert (D : forall x, Y x - g x = 0).
        { intros x; rewrite (proportional (fun x => Y x - g x) (fun x => 2 * h * X x)).
          - unfold g; rewrite (X_0 _ _ _ _ E), (Y_0 _ _ _ _ E); ring.
          - intros y; pose proof (derivative_Y _ _ _ _ E y) as DY; pose proof (derive_g y) as DG.
            refine (derive_as _ _ _ _ (derive_difference _ _ _ _ _ DY DG) _); unfold g; rewrite <- P; ring.
          - intros y; exists (2 * h * Y y); pose proof (derivative_X _ _ _ _ E y); derive_known; ring. }
        revert Z; rewrite (proportional g (fun x => - 2 * h * X x)).
        + unfold g; rewrite (X_0 _ _ _ _ E); pose proof (exp_pos (RInt (fun x => - 2 * h * X x) 0 t)); nra.
        + intros y; refine (derive_as _ _ _ _ (derive_g y) _); specialize (D y).
          replace (Y y) with (g y) by lra; ring.
        + intros y; exists (- 2 * h * Y y); pose proof (derivative_X _ _ _ _ E y); derive_known; ring.
    Qed.

    Lemma bounded t : 0 < g t.
    Proof.
      apply (stays_positive g (fun t => - 2 * h * X t * Y t)).
      - apply derive_g.
      - unfold g; rewrite (X_0 _ _ _ _ E); lra.
      - apply never_zero.
    Qed.
  End One.

  Lemma elapsed_unique X Y U V : elapsed (2 * h + gap) (h ^ 2) X Y -> elapsed (2 * h + gap) (h ^ 2) U V ->
    forall t, U t = X t /\ V t = Y t.
  Proof.
    intros E F; set (e t := (U t - X t) ^ 2 + (V t - Y t) ^ 2).
    assert (Z : forall t, e t = 0).
    { apply (stays_zero e (fun t => 2 * (U t - X t) * (V t - Y t) + 2 * (V t - Y t) *
        ((- (2 * h + gap) + 2 * h * (h * U t ^ 2 + h * (U t * X t) + h * X t ^ 2)) * (U t - X t)))
        (1 + (8 * h + gap))); try intros t.
      - destruct E as [DX DY _ _], F as [DU DV _ _].
        specialize (DX t); specialize (DY t); specialize (DU t); specialize (DV t).
        unfold e; derive_known; ring.
      - pose proof (bounded X Y E t) as B; pose proof (bounded U V F t) as C; cbv beta in B, C.
        unfold e; set (x := X t) in *; set (u := U t) in *; set (y := Y t) in *; set (v := V t) in *.
        clearbody x u y v.
        set (k := - (2 * h + gap) + 2 * h * (h * u ^ 2 + h * (u * x) + h * x ^ 2)).
        assert (K : Rabs k <= 8 * h + gap).
        { pose proof (pow2_ge_0 u); pose proof (pow2_ge_0 x).
          assert (0 <= h * u ^ 2 /\ 0 <= h * x ^ 2) by (split; now apply Rmult_le_pos).
          assert (0 <= h * (u + x) ^ 2 /\ 0 <= h * (u - x) ^ 2)
            by (split; apply Rmult_le_pos; trivial; apply pow2_ge_0).
          assert (- 1 <= h * (u * x) <= 1) by lra.
          set (w := h * u ^ 2 + h * (u * x) + h * x ^ 2) in *.
          assert (- 1 <= w <= 3) by (unfold w; lra).
          apply Rabs_le; unfold k; nra. }
        replace (2 * (u - x) * (v - y) + 2 * (v - y) * (k * (u - x)))
          with ((1 + k) * (2 * (u - x) * (v - y))) by ring.
        rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos.
        + eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_R1; lra.
        + apply Rabs_le; pose proof (pow2_ge_0 (u - x + (v - y))); pose proof (pow2_ge_0 (u - x - (v - y)));
          lra.
      - unfold e; pose proof (pow2_ge_0 (U t - X t)); pose proof (pow2_ge_0 (V t - Y t)); lra.
      - unfold e; rewrite (X_0 _ _ _ _ E), (Y_0 _ _ _ _ E), (X_0 _ _ _ _ F), (Y_0 _ _ _ _ F); ring. }
    intros t; specialize (Z t); unfold e in Z.
    pose proof (pow2_ge_0 (U t - X t)); pose proof (pow2_ge_0 (V t - Y t)).
    assert (A : (U t - X t) ^ 2 = 0 /\ (V t - Y t) ^ 2 = 0) by lra.
    destruct A as (A & B); rewrite <- Rsqr_pow2 in A, B; apply Rsqr_eq_0 in A, B; lra.
  Qed.

  Section Symmetry.
    Variables (X Y : R -> R) (E : elapsed (2 * h + gap) (h ^ 2) X Y).

    Lemma backwards t : X (- t) = - X t /\ Y (- t) = Y t.
    Proof.
      assert (F : elapsed (2 * h + gap) (h ^ 2) (fun t => - X (- t)) (fun t => Y (- t))).
      { constructor; [intros s; pose proof (derivative_X _ _ _ _ E (- s)) as D
          | intros s; pose proof (derivative_Y _ _ _ _ E (- s)) as D | |].
        - refine (derive_as _ _ _ _ (is_derive_opp _ _ _ (is_derive_comp X (fun s => - s) s _ _ D
            (is_derive_opp (fun s => s) s 1 (is_derive_id s)))) _).
          unfold opp, scal; cbn; unfold mult; cbn; ring.
        - refine (derive_as _ _ _ _ (is_derive_comp Y (fun s => - s) s _ _ D
            (is_derive_opp (fun s => s) s 1 (is_derive_id s))) _).
          unfold opp, scal; cbn -[pow]; unfold mult; cbn -[pow]; ring.
        - rewrite Ropp_0, (X_0 _ _ _ _ E); ring.
        - rewrite Ropp_0; apply E. }
      destruct (elapsed_unique X Y _ _ E F t); lra.
    Qed.

    (* X and Y at twice the time. *)
    Lemma doubled t : let names := {| doubling.e_1 := 2 * h + gap; doubling.e_2 := h ^ 2; doubling.X_ := X;
      doubling.Y := Y |} in
      X (2 * t) = doubling.X_next names t /\ Y (2 * t) = doubling.Y_next names t.
    Proof.
      intros names.
      assert (N : doubling.holds names).
      { constructor; cbn -[pow].
        - intros s; pose proof (bounded X Y E s) as B; cbv beta in B.
          replace (1 - _) with ((1 - h * X s ^ 2) * (1 + h * X s ^ 2)) by ring.
          pose proof (Rmult_le_pos _ _ H (pow2_ge_0 (X s))); nra.
        - intros s; rewrite (curve X Y E s); ring.
        - apply E.
        - apply E. }
      assert (F : elapsed (2 * h + gap) (h ^ 2) (fun t => doubling.X_next names (t / 2))
        (fun t => doubling.Y_next names (t / 2))).
      { pose proof (fun s => doubling.fact_rates names N s) as D.
        assert (half : forall s, is_derive (fun s => s / 2) s (1 / 2)) by (intros s; auto_derive;
          [easy | field]).
        constructor; [intros s; destruct (D (s / 2)) as (A & _) | intros s;
          destruct (D (s / 2)) as (_ & A) | |].
        - refine (derive_as _ _ _ _ (is_derive_comp _ (fun s => s / 2) s _ _ A (half s)) _).
          unfold scal; cbn -[doubling.Y_next]; unfold mult; cbn -[doubling.Y_next]; field.
        - refine (derive_as _ _ _ _ (is_derive_comp _ (fun s => s / 2) s _ _ A (half s)) _).
          unfold scal; cbn -[doubling.X_next pow]; unfold mult; cbn -[doubling.X_next pow]; field.
        - replace (0 / 2) with 0 by field; unfold doubling.X_next, doubling.inside; cbn.
          rewrite (X_0 _ _ _ _ E); field.
        - replace (0 / 2) with 0 by field; unfold doubling.Y_next, doubling.inside; cbn.
          rewrite (X_0 _ _ _ _ E); field. }
      destruct (elapsed_unique X Y _ _ E F (2 * t)) as (A & B).
      replace (2 * t / 2) with t in A, B by field; now split.
    Qed.
  End Symmetry.
End Elapsed.

(* * Signs: n is the direction of the momentum, h_a, h_d and h_b = - h_a - h_d are the differences of
   inverse moments, and x, y are X, Y at a time. *)
Section Signs.
  Variables (h_a h_d n_a n_b n_d x y : R).
  Let h_b := - h_a - h_d.
  Let h := h_a * (h_d * n_b ^ 2 - h_b * n_d ^ 2) / 4.
  Let gap := - h_b * (h_d * n_a ^ 2 - h_a * n_d ^ 2).
  Hypotheses (Unit : n_a ^ 2 + n_b ^ 2 + n_d ^ 2 = 1) (Side : 0 <= n_a) (Middle : 0 <= h_a * h_d)
    (Gap : 0 <= gap) (G : 0 < 1 - h * x ^ 2) (Curve : y ^ 2 = (1 - h * x ^ 2) ^ 2 - gap * x ^ 2).

  Lemma not_middle : 0 <= - h_a * h_b.
  Proof. unfold h_b; pose proof (pow2_ge_0 h_a); nra. Qed.

  Lemma h_nonnegative : 0 <= h.
  Proof.
    pose proof not_middle as M; unfold h.
    pose proof (Rmult_le_pos _ _ Middle (pow2_ge_0 n_b)); pose proof (Rmult_le_pos _ _ M (pow2_ge_0 n_d));
      nra.
  Qed.

  Lemma room_positive : 0 < (1 + h * x ^ 2) ^ 2 - h_a * h_d * n_b ^ 2 * x ^ 2.
  Proof.
    replace (_ - _) with ((1 - h * x ^ 2) ^ 2 + - h_a * h_b * (n_d * x) ^ 2) by (unfold h; field).
    pose proof (Rmult_le_pos _ _ not_middle (pow2_ge_0 (n_d * x))); pose proof (pow_lt _ 2 G); lra.
  Qed.

  Lemma factor_positive : 0 < 1 - h * ((n_b / (1 + n_a)) ^ 2 - (n_d / (1 + n_a)) ^ 2) * x ^ 2.
  Proof.
    assert (B : (n_b / (1 + n_a)) ^ 2 <= 1).
    { replace ((n_b / (1 + n_a)) ^ 2) with (n_b ^ 2 / (1 + n_a) ^ 2) by (field; lra).
      assert (P : 0 < (1 + n_a) ^ 2) by (apply pow_lt; lra).
      apply (Rmult_le_reg_r _ _ _ P); replace (n_b ^ 2 / (1 + n_a) ^ 2 * (1 + n_a) ^ 2) with (n_b ^ 2)
        by (field; lra).
      pose proof (pow2_ge_0 n_d); nra. }
    pose proof (pow2_ge_0 (n_d / (1 + n_a))) as D.
    pose proof (Rmult_le_pos _ _ h_nonnegative (pow2_ge_0 x)) as P.
    set (z := (n_b / _) ^ 2 - _) in *; assert (Z : z <= 1) by (unfold z; lra).
    replace (h * z * x ^ 2) with (h * x ^ 2 * z) by ring; clearbody z h; nra.
  Qed.

  Lemma side_kept : 0 <= n_a * (1 + h * x ^ 2) * (1 - h * x ^ 2) + h_a * n_b * n_d * x * y.
  Proof.
    pose proof (Rmult_le_pos _ _ h_nonnegative (pow2_ge_0 x)) as P.
    assert (Steep : 0 <= h_a * (h_d * n_a ^ 2 - h_a * n_d ^ 2)).
    { unfold gap, h_b in Gap; destruct (total_order_T h_a 0) as [[L|E]|R].
      - assert (h_d <= 0) by nra; nra.
      - rewrite E; lra.
      - assert (0 <= h_d) by nra; nra. }
    set (g := 1 - h * x ^ 2) in *; set (f := 1 + h * x ^ 2) in *.
    assert (S : (h_a * n_b * n_d * x * y) ^ 2 <= (n_a * f * g) ^ 2).
    { pose proof (Rmult_le_pos _ _ Gap (pow2_ge_0 x)) as Q; pose proof (pow2_ge_0 y) as Y2.
      assert (F : 4 * h * x ^ 2 <= f ^ 2) by (pose proof (pow2_ge_0 g); unfold f, g in *; lra).
      assert (A : (h_a * n_b * n_d) ^ 2 <= n_a ^ 2 * (4 * h)).
      { replace (n_a ^ 2 * (4 * h)) with ((h_a * n_b * n_d) ^ 2 + n_b ^ 2 * (h_a * (h_d * n_a ^ 2
        - h_a * n_d ^ 2))
          + - h_a * h_b * (n_a * n_d) ^ 2) by (unfold h; field).
        pose proof (Rmult_le_pos _ _ (pow2_ge_0 n_b) Steep);
          pose proof (Rmult_le_pos _ _ not_middle (pow2_ge_0 (n_a * n_d))); lra. }
      replace ((_ * y) ^ 2) with ((h_a * n_b * n_d) ^ 2 * (x ^ 2 * y ^ 2)) by ring.
      apply Rle_trans with (n_a ^ 2 * (4 * h) * (x ^ 2 * y ^ 2)).
      - apply Rmult_le_compat_r; [apply Rmult_le_pos; [apply pow2_ge_0 | assumption] | exact A].
      - replace (n_a ^ 2 * (4 * h) * (x ^ 2 * y ^ 2)) with (n_a ^ 2 * (4 * h * x ^ 2 * y ^ 2)) by ring.
        replace ((n_a * f * g) ^ 2) with (n_a ^ 2 * (f ^ 2 * g ^ 2)) by ring.
        apply Rmult_le_compat_l; [apply pow2_ge_0 |].
        apply Rmult_le_compat; [lra | assumption | exact F | lra]. }
    assert (N : 0 <= n_a * f * g) by (repeat apply Rmult_le_pos; unfold f; lra).
    clearbody f g; nra.
  Qed.
End Signs.

(* * The body: b is its middle axis, s the side of axis a, and K^2 is on the side of a. *)
Record from_side (h s c_a c_b c_d v_a v_b v_d : R) : Prop := FromSide {
  hand : h ^ 2 = 1;
  side : s ^ 2 = 1;
  positive_a : 0 < c_a;
  positive_b : 0 < c_b;
  positive_d : 0 < c_d;
  middle : 0 <= (c_a - c_b) * (c_b - c_d);
  chosen : 0 <= (c_a - c_d) * (c_a * (c_a - c_b) * v_a ^ 2 - c_d * (c_b - c_d) * v_d ^ 2);
  towards : 0 <= s * v_a;
  moves : 0 < v_a ^ 2 + v_b ^ 2 + v_d ^ 2
}.

(* After an exchange of a and d where that is needed, each start is such. *)
Theorem each_start_has_a_side h c_a c_b c_d v_a v_b v_d :
  h ^ 2 = 1 -> 0 < c_a -> 0 < c_b -> 0 < c_d -> 0 <= (c_a - c_b) * (c_b - c_d) ->
  0 < v_a ^ 2 + v_b ^ 2 + v_d ^ 2 -> exists s,
  from_side h s c_a c_b c_d v_a v_b v_d \/ from_side (- h) s c_d c_b c_a v_d v_b v_a.
Proof.
  intros H Ca Cb Cd M V.
  assert (sign : forall x, exists s, s ^ 2 = 1 /\ 0 <= s * x).
  { intros x; destruct (Rle_dec 0 x); [exists 1 | exists (-1)]; split; lra. }
  destruct (Rle_dec 0 ((c_a - c_d) * (c_a * (c_a - c_b) * v_a ^ 2 - c_d * (c_b - c_d) * v_d ^ 2))) as [C|C].
  - destruct (sign v_a) as (s & S & T); exists s; left; now constructor.
  - destruct (sign v_d) as (s & S & T); exists s; right; constructor; trivial; lra.
Qed.

(* The names of the ledger. *)
Definition stepping (h s c_a c_b c_d v_a v_b v_d : R) (X Y : R -> R) : step.names := {|
  step.epsilon := h; step.sigma := s; step.i_a := 1 / c_a; step.i_b := 1 / c_b; step.i_d := 1 / c_d;
  step.M_a0 := c_a * v_a; step.M_b0 := c_b * v_b; step.M_d0 := c_d * v_d;
  step.K := sqrt ((c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2);
  step.X_ := X; step.Y := Y |}.

Section Step.
  Variables (h s c_a c_b c_d v_a v_b v_d : R) (X Y : R -> R).
  Let S := stepping h s c_a c_b c_d v_a v_b v_d X Y.
  Hypotheses (B : from_side h s c_a c_b c_d v_a v_b v_d) (E : elapsed (step.e_1 S) (step.e_2 S) X Y).
  Let K := sqrt ((c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2).

  Lemma size : 0 < K /\ K ^ 2 = (c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2.
  Proof.
    destruct B as [_ _ Ca Cb Cd _ _ _ V].
    assert (P : 0 < (c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2).
    { rewrite !Rpow_mult_distr; pose proof (pow_lt _ 2 Ca); pose proof (pow_lt _ 2 Cb);
      pose proof (pow_lt _ 2 Cd).
      pose proof (pow2_ge_0 v_a); pose proof (pow2_ge_0 v_b); pose proof (pow2_ge_0 v_d).
      destruct (Req_dec v_a 0) as [Z|Z]; [|pose proof (pow2_gt_0 _ Z); nra].
      destruct (Req_dec v_b 0) as [Z'|Z']; [|pose proof (pow2_gt_0 _ Z'); nra].
      rewrite Z, Z' in *; nra. }
    split; [now apply sqrt_lt_R0 | apply pow2_sqrt; lra].
  Qed.

  Let h_a := step.h_a S.
  Let h_d := step.h_d S.
  Let n_a := step.n_a0 S.
  Let n_b := step.n_b0 S.
  Let n_d := step.n_d0 S.
  Let gap := - (- h_a - h_d) * (h_d * n_a ^ 2 - h_a * n_d ^ 2).

  Lemma direction : n_a ^ 2 + n_b ^ 2 + n_d ^ 2 = 1 /\ 0 <= n_a /\ 0 <= h_a * h_d /\ 0 <= gap.
  Proof.
    destruct B as [H2 S2 Ca Cb Cd M C T _], size as (P & K2).
    assert (Q : forall x, 0 <= x -> 0 <= x / K) by
      (intros x Z; apply Rmult_le_pos; [exact Z | left; now apply Rinv_0_lt_compat]).
    repeat split.
    - unfold n_a, n_b, n_d, step.n_a0, step.n_b0, step.n_d0; cbn -[pow]; fold K.
      transitivity ((s ^ 2 * (c_a * v_a) ^ 2 + s ^ 2 * h ^ 2 * (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2) / K ^ 2);
        [field; lra | rewrite H2, S2, K2; field; rewrite <- K2; apply pow_nonzero; lra].
    - unfold n_a, step.n_a0; cbn -[pow]; fold K; apply Q.
      replace (s * (c_a * v_a)) with (c_a * (s * v_a)) by ring; apply Rmult_le_pos; lra.
    - unfold h_a, h_d, step.h_a, step.h_d; cbn -[pow]; fold K.
      replace (_ * _) with (K ^ 2 * ((c_a - c_b) * (c_b - c_d) / (c_a * c_b ^ 2 * c_d))) by (field; lra).
      apply Rmult_le_pos; [apply pow2_ge_0 |]; apply Rmult_le_pos; [exact M | left; apply Rinv_0_lt_compat].
      repeat apply Rmult_lt_0_compat; lra.
    - unfold gap, h_a, h_d, n_a, n_d, step.h_a, step.h_d, step.n_a0, step.n_d0; cbn -[pow]; fold K.
      replace (_ * _) with ((c_a - c_d) * (s ^ 2 * (c_a * (c_a - c_b) * v_a ^ 2) - c_d * (c_b - c_d)
        * v_d ^ 2)
        / (c_a * c_b * c_d)) by (field; lra).
      rewrite S2, Rmult_1_l; apply Rmult_le_pos; [exact C | left; apply Rinv_0_lt_compat].
      repeat apply Rmult_lt_0_compat; lra.
  Qed.

  Lemma frequencies : step.h S = h_a * (h_d * n_b ^ 2 - (- h_a - h_d) * n_d ^ 2) / 4 /\
    step.e_1 S = 2 * step.h S + gap /\ step.e_2 S = step.h S ^ 2.
  Proof.
    destruct B as [H2 S2 Ca Cb Cd _ _ _ _], size as (P & K2); repeat split;
      [|unfold step.e_1; apply (f_equal (Rplus _))];
      unfold gap, h_a, h_d, n_a, n_b, n_d, step.h, step.h_a, step.h_d, step.n_a0, step.n_b0, step.n_d0;
      cbn -[pow]; fold K.
    - field_simplify; [rewrite H2, S2; field | |]; lra.
    - field_simplify; [rewrite S2; field | |]; lra.
  Qed.
  Lemma h_positive : 0 <= step.h S.
  Proof.
    destruct frequencies as (-> & _ & _), direction as (_ & _ & M & _).
    now apply h_nonnegative.
  Qed.

  Lemma functions : elapsed (2 * step.h S + gap) (step.h S ^ 2) X Y.
  Proof. destruct frequencies as (_ & E1 & E2); rewrite <- E1, <- E2; exact E. Qed.

  Lemma g_positive t : 0 < 1 - step.h S * X t ^ 2.
  Proof. exact (bounded _ gap (proj2 (proj2 (proj2 direction))) X Y functions t). Qed.

  Lemma curve_of_g t : Y t ^ 2 = (1 - step.h S * X t ^ 2) ^ 2 - gap * X t ^ 2.
  Proof. rewrite (curve _ gap X Y functions t); ring. Qed.

  Lemma positive_inverse : 0 < 1 / c_a /\ 0 < 1 / c_b /\ 0 < 1 / c_d.
  Proof. destruct B; repeat split; apply Rdiv_lt_0_compat; lra. Qed.

  Lemma in_direction x : step.M_a0 S = K * s * n_a /\ step.M_b0 S = K * s * h * n_b /\
    step.M_d0 S = K * n_d /\
    K * (x * h_a) = K * (x * (K * (1 / c_d - 1 / c_b))).
  Proof.
    destruct B as [H2 S2 _ _ _ _ _ _ _], size as (P & _).
    unfold n_a, n_b, n_d, step.n_a0, step.n_b0, step.n_d0; cbn -[pow]; fold K; repeat split.
    - transitivity (s ^ 2 * (c_a * v_a)); [rewrite S2; ring | field; lra].
    - transitivity (s ^ 2 * h ^ 2 * (c_b * v_b)); [rewrite S2, H2; ring | field; lra].
    - field; lra.
  Qed.

  Lemma f_of t : step.f S t = 1 + step.h S * X t ^ 2.
  Proof. unfold step.f; change (step.X_ S t) with (X t); ring. Qed.
  Lemma g_of t : step.g S t = 1 - step.h S * X t ^ 2.
  Proof. unfold step.g; change (step.X_ S t) with (X t); ring. Qed.

  Lemma room_of t : step.room S t = (1 + step.h S * X t ^ 2) ^ 2 - h_a * h_d * n_b ^ 2 * X t ^ 2.
  Proof.
    destruct B as [H2 S2 Ca Cb Cd _ _ _ _], size as (P & _).
    unfold step.room, step.f, h_a, h_d, n_b, step.h_a, step.h_d, step.n_b0.
    change (step.X_ S t) with (X t); set (hh := step.h S); cbn -[pow]; fold K.
    transitivity ((1 + hh * X t ^ 2) ^ 2
      - s ^ 2 * h ^ 2 * ((1 / c_d - 1 / c_b) * (1 / c_b - 1 / c_a) * (c_b * v_b) ^ 2 * X t ^ 2));
      [rewrite S2, H2; ring | field; lra].
  Qed.

  Lemma room_not_zero t : 0 < step.room S t.
  Proof.
    destruct direction as (U & N & M & G), frequencies as (F & _ & _).
    pose proof (g_positive t) as P; rewrite room_of, F in *; now apply room_positive.
  Qed.

  Lemma kept t : 0 <= s * step.M_a S t.
  Proof.
    destruct direction as (U & N & M & G), frequencies as (F & _ & _), size as (Kp & _).
    pose proof B as [H2 S2 Ca Cb Cd _ _ _ _].
    pose proof (g_positive t) as P; pose proof (curve_of_g t) as C; pose proof (room_not_zero t) as Q.
    pose proof (in_direction 0) as (Ma & Mb & Md & _).
    unfold step.M_a; rewrite Ma, Mb, Md.
    replace (s * _) with (K * (n_a * step.f S t * step.g S t + h_a * n_b * n_d * X t * Y t) / step.room S t).
    - apply Rmult_le_pos; [|left; now apply Rinv_0_lt_compat]; apply Rmult_le_pos; [lra|].
      rewrite f_of, g_of, F in *.
      now apply side_kept.
    - unfold h_a, step.h_a; change (step.K S) with K; change (step.X_ S t) with (X t);
      change (step.Y S t) with (Y t).
      change (step.epsilon S) with h.
      transitivity ((s ^ 2 * (K * (n_a * step.f S t * step.g S t))
        + s ^ 2 * h ^ 2 * (K * (K * (step.i_d S - step.i_b S) * n_b * n_d * X t * Y t))) / step.room S t);
        [rewrite S2, H2|]; field; lra.
  Qed.

  Lemma z_of : step.z_re S = n_d / (1 + n_a) /\ step.z_im S = n_b / (1 + n_a).
  Proof.
    destruct direction as (_ & N & _ & _), size as (Kp & _), (in_direction 0) as (Ma & Mb & Md & _).
    pose proof B as [H2 S2 _ _ _ _ _ _ _].
    unfold step.z_re, step.z_im; rewrite Ma, Mb, Md.
    change (step.K S) with K; change (step.sigma S) with s; change (step.epsilon S) with h.
    replace (K + s * (K * s * n_a)) with (K * (1 + n_a)) by ring [S2]; split; [field; lra|].
    match goal with |- ?above / _ = _ => replace above with (K * n_b) by ring [S2 H2] end; field; lra.
  Qed.

  Lemma G_positive t : 0 < step.G_re S t.
  Proof.
    destruct direction as (U & N & M & G), frequencies as (F & _ & _), size as (Kp & _).
    pose proof B as [H2 S2 Ca Cb Cd _ _ _ _].
    pose proof (g_positive t) as P; pose proof (factor_positive h_a h_d n_a n_b n_d (X t) U N M) as Q.
    rewrite <- F in Q; specialize (Q P).
    destruct z_of as (Zr & Zi).
    replace (step.G_re S t) with (1 - step.h S * ((n_b / (1 + n_a)) ^ 2 - (n_d / (1 + n_a)) ^ 2) * X t ^ 2);
      [exact Q|].
    unfold step.G_re, step.nu_re; rewrite Zr, Zi; change (step.X_ S t) with (X t); ring.
  Qed.

  Lemma step_in_ledger : step.holds S.
  Proof.
    destruct size as (Kp & K2), positive_inverse as (Ia & Ib & Id); pose proof B as [H2 S2 Ca Cb Cd _ _ T _].
    assert (Start : 0 < K + s * (c_a * v_a))
      by (replace (s * (c_a * v_a)) with (c_a * (s * v_a)) by ring; pose proof (Rmult_le_pos c_a (s * v_a));
        lra).
    constructor; try (now apply Rgt_not_eq).
    - intros t; unfold step.square; pose proof (pow_lt _ 2 (G_positive t));
      pose proof (pow2_ge_0 (step.G_im S t)); lra.
    - intros t; apply Rgt_not_eq, room_not_zero.
    - intros t; apply Rgt_not_eq; change (0 < K + s * step.M_a S t); pose proof (kept t); lra.
    - cbn -[pow]; lra.
    - cbn -[pow]; lra.
    - cbn -[pow sqrt]; fold K; lra.
    - intros t; destruct frequencies as (_ & -> & ->).
      change (step.X_ S t) with (X t); change (step.Y S t) with (Y t).
      pose proof (curve _ gap X Y functions t) as C; ring [C].
    - change (0 <= K); lra.
    - apply E.
    - intros t; refine (derive_as _ _ _ _ (derivative_Y _ _ _ _ E t) _).
      change (step.X_ S t) with (X t); ring.
  Qed.

  Lemma moments : step.c_a S = c_a /\ step.c_b S = c_b /\ step.c_d S = c_d.
  Proof. destruct B; unfold step.c_a, step.c_b, step.c_d; cbn; repeat split; field; lra. Qed.

  Lemma step_rates : euler h c_a c_b c_d (step.Omega_a S) (step.Omega_b S) (step.Omega_d S).
  Proof.
    intros t; pose proof (step.fact_euler S step_in_ledger t) as D.
    destruct moments as (Ca & Cb & Cd); rewrite Ca, Cb, Cd in D; change (step.epsilon S) with h in D; as_euler D.
  Qed.

  Lemma step_rates_start : step.Omega_a S 0 = v_a /\ step.Omega_b S 0 = v_b /\ step.Omega_d S 0 = v_d.
  Proof.
    destruct B as [_ _ Ca Cb Cd _ _ _ _].
    unfold step.Omega_a, step.Omega_b, step.Omega_d, step.M_a, step.M_b, step.M_d, step.room, step.f, step.g.
    change (step.X_ S 0) with (X 0); change (step.Y S 0) with (Y 0); rewrite (X_0 _ _ _ _ E), (Y_0 _ _ _ _ E).
    set (x := step.h S); cbn; repeat split; field; lra.
  Qed.

  Lemma momentum_of_rates t : step.M_a S t = c_a * step.Omega_a S t /\
    step.M_b S t = c_b * step.Omega_b S t /\
    step.M_d S t = c_d * step.Omega_d S t.
  Proof.
    destruct B as [_ _ Ca Cb Cd _ _ _ _]; unfold step.Omega_a, step.Omega_b, step.Omega_d.
    set (a := step.M_a S t); set (b := step.M_b S t); set (d := step.M_d S t); cbn; repeat split; field; lra.
  Qed.

  (* Half of psi: its linear part, the integral J, and half the argument of G. *)
  Section Angle.
    Variables (J : R -> R) (J_rate : forall t, is_derive J t (step.J_rate S t)) (J_0 : J 0 = 0).
    Definition bent t := J t - atan (step.G_im S t / step.G_re S t) / 2.
    Definition half_psi t := step.psi_0 S / 2 * t + bent t.

    Lemma derive_factor t : is_derive (step.G_re S) t (step.G_re_rate S t) /\
      is_derive (step.G_im S) t (step.G_im_rate S t).
    Proof.
      pose proof (derivative_X _ _ _ _ E t).
      unfold step.G_re, step.G_im, step.G_re_rate, step.G_im_rate.
      set (a := step.nu_re S); set (b := step.nu_im S); cbn -[pow]; split; derive_known; ring.
    Qed.

    Lemma derive_argument t :
      is_derive (fun t => atan (step.G_im S t / step.G_re S t)) t (step.G_rate S t).
    Proof.
      pose proof (G_positive t) as P; destruct (derive_factor t) as (Dr & Di).
      refine (derive_as _ _ _ _ (is_derive_comp atan _ t _ _ (is_derive_atan _)
        (is_derive_div _ _ t _ _ Di Dr (Rgt_not_eq _ _ P))) _).
      unfold scal; cbn -[pow step.G_re step.G_im step.G_re_rate step.G_im_rate]; unfold mult.
      cbn -[pow step.G_re step.G_im step.G_re_rate step.G_im_rate].
      unfold step.G_rate, step.square, step.G_re_rate, step.G_im_rate, Rsqr.
      assert (Im : step.G_im S t = - step.nu_im S * X t ^ 2)
        by (unfold step.G_im; change (step.X_ S t) with (X t); ring).
      assert (Re : step.G_re S t = 1 - step.nu_re S * X t ^ 2)
        by (unfold step.G_re; change (step.X_ S t) with (X t); ring).
      change (step.X_ S t) with (X t); change (step.Y S t) with (Y t).
      set (re := step.G_re S t) in *; set (im := step.G_im S t) in *.
      set (nr := step.nu_re S) in *; set (ni := step.nu_im S) in *; clearbody nr ni.
      pose proof (pow2_ge_0 im); pose proof (pow_lt _ 2 P).
      transitivity ((-2 * ni * X t * Y t * re - im * (-2 * nr * X t * Y t)) / (re ^ 2 + im ^ 2));
        [field; split; nra|].
      apply (f_equal2 Rdiv); [|easy]; rewrite Im, Re; ring.
    Qed.

    Lemma derive_half_psi t : is_derive half_psi t (step.psi_rate S t / 2).
    Proof.
      pose proof (J_rate t) as DJ; pose proof (derive_argument t) as DG; unfold half_psi, bent.
      pose proof (step.fact_psi_rate_of_point S step_in_ledger t) as A.
      pose proof (step.fact_psi S step_in_ledger t) as P; pose proof (step.fact_turn_0 S step_in_ledger t)
        as T.
      set (arg := fun t => atan _) in DG.
      change (is_derive (fun t => step.psi_0 S / 2 * t + (J t - arg t / 2)) t (step.psi_rate S t / 2)).
      clearbody arg.
      apply (derive_as _ t (step.psi_0 S / 2 + (step.J_rate S t - step.G_rate S t / 2))).
      - derive_known; field.
      - rewrite A, P, T; field.
    Qed.

    Theorem step_motion p : norm_squared p = 1 ->
      the_motion h c_a c_b c_d v_a v_b v_d p (step.Omega_a S) (step.Omega_b S) (step.Omega_d S)
        (from_start h p (fun t => pulled_back h s K (c_a * step.Omega_a S t) (c_b * step.Omega_b S t)
          (c_d * step.Omega_d S t) (2 * half_psi t))).
    Proof.
      intros P; pose proof B as [H2 S2 Ca Cb Cd _ _ _ _]; destruct step_rates_start as (Sa & Sb & Sd),
        size as (Kp & _).
      assert (M : forall t, K + s * (c_a * step.Omega_a S t) = K + s * step.M_a S t)
        by (intros t; now rewrite (proj1 (momentum_of_rates t))).
      apply (pulled_back_motion h s c_a c_b c_d v_a v_b v_d p (step.Omega_a S) (step.Omega_b S)
        (step.Omega_d S)
        (fun t => 2 * half_psi t) H2 S2 Ca Cb Cd step_rates P Sa Sb Sd Kp); fold K; intros t.
      - rewrite M; pose proof (kept t); lra.
      - pose proof (derive_half_psi t) as D; derive_known.
        unfold step.psi_rate; rewrite (step.fact_energy S step_in_ledger t), M.
        replace (step.H_0 S) with (energy c_a c_b c_d v_a v_b v_d);
          [change (step.K S) with K; change (step.sigma S) with s; field; pose proof (kept t); lra|].
        unfold step.H_0; destruct moments as (-> & -> & ->).
        unfold energy, step.Omega_a0, step.Omega_b0, step.Omega_d0; cbn -[pow]; field; lra.
    Qed.
  End Angle.

  (* The projection of the momentum's direction. *)
  Lemma projection t : step.w_re S t * (K + s * step.M_a S t) = step.M_d S t /\
    step.w_im S t * (K + s * step.M_a S t) = s * h * step.M_b S t.
  Proof.
    destruct size as (Kp & _), frequencies as (F & _ & _), direction as (_ & N & _ & _).
    pose proof B as [H2 S2 Ca Cb Cd _ _ _ _].
    set (T := step.as_turn S); pose proof (turn.fact_projection T (step.models_turn S step_in_ledger) t) as P.
    pose proof (in_direction 0) as (Ma & Mb & Md & _).
    assert (Z : turn.z_re T = step.z_re S /\ turn.z_im T = step.z_im S).
    { destruct z_of as (-> & ->); split; reflexivity. }
    destruct Z as (Zr & Zi).
    assert (Q : turn.zr_re T = step.zr_re S /\ turn.zr_im T = step.zr_im S).
    { unfold step.zr_re, step.zr_im; rewrite <- Zr, <- Zi, Ma, Mb, Md; unfold turn.zr_re, turn.zr_im.
      set (zr := turn.z_re T); set (zi := turn.z_im T); clearbody zr zi.
      change (turn.n_a0 T) with n_a; change (turn.n_b0 T) with n_b; change (turn.n_d0 T) with n_d.
      unfold turn.h_b; change (turn.h_a T) with (K * (1 / c_d - 1 / c_b));
        change (turn.h_d T) with (K * (1 / c_b - 1 / c_a)).
      cbn -[pow sqrt]; fold K; replace (K + s * (K * s * n_a)) with (K * (1 + n_a)) by ring [S2].
      clearbody K n_a n_b n_d; split.
      - transitivity (n_b * (h ^ 2 * s ^ 2 * (K * (1 / c_b - 1 / c_a) * n_a)
        - h ^ 2 * s ^ 2 * (zr * (K * (1 / c_d - 1 / c_b)) * n_d)) / (1 + n_a));
          [rewrite H2, S2; field; lra | field; lra].
      - transitivity (n_d * (s ^ 2 * ((- (K * (1 / c_d - 1 / c_b)) - K * (1 / c_b - 1 / c_a)) * n_a)
          - h ^ 2 * s ^ 2 * (zi * (K * (1 / c_d - 1 / c_b)) * n_b)) / (1 + n_a));
          [rewrite H2, S2; field; lra | field; lra]. }
    destruct Q as (Qr & Qi).
    assert (Th : turn.h T = step.h S).
    { rewrite F; unfold turn.h, turn.h_b; change (turn.h_a T) with h_a; change (turn.h_d T) with h_d;
        change (turn.n_b0 T) with n_b; change (turn.n_d0 T) with n_d; field. }
    assert (Tf : turn.f T t = step.f S t)
      by (rewrite f_of; unfold turn.f; rewrite Th; change (turn.X_ T t) with (X t); ring).
    assert (Tg : turn.g T t = step.g S t)
      by (rewrite g_of; unfold turn.g; rewrite Th; change (turn.X_ T t) with (X t); ring).
    assert (Room : turn.room T t = step.room S t).
    { rewrite room_of; unfold turn.room; rewrite Tf, f_of; change (turn.X_ T t) with (X t);
        change (turn.h_a T) with h_a; change (turn.h_d T) with h_d; change (turn.n_b0 T) with n_b; ring. }
    assert (W : turn.w_re T t = step.w_re S t /\ turn.w_im T t = step.w_im S t).
    { unfold turn.w_re, turn.w_im, turn.F_re, turn.F_im, turn.square, turn.G_re, turn.G_im, turn.nu_re,
      turn.nu_im.
      rewrite Qr, Qi, Zr, Zi, Th; split; reflexivity. }
    destruct W as (Wr & Wi); rewrite Wr, Wi in P; destruct P as (Pr & Pi).
    assert (A : turn.n_a T t = s * step.M_a S t / K /\ turn.n_b T t = s * h * step.M_b S t / K /\
      turn.n_d T t = step.M_d S t / K).
    { unfold turn.n_a, turn.n_b, turn.n_d, step.M_a, step.M_b, step.M_d; rewrite Room, Tf, Tg, f_of, g_of.
      pose proof (room_not_zero t) as R; rewrite Ma, Mb, Md.
      unfold turn.h_b; change (turn.h_a T) with (K * (1 / c_d - 1 / c_b));
        change (turn.h_d T) with (K * (1 / c_b - 1 / c_a)).
      change (turn.n_a0 T) with n_a; change (turn.n_b0 T) with n_b; change (turn.n_d0 T) with n_d.
      change (turn.X_ T t) with (X t); change (turn.Y T t) with (Y t).
      change (step.X_ S t) with (X t); change (step.Y S t) with (Y t); change (step.epsilon S) with h.
      change (step.i_a S) with (1 / c_a); change (step.i_b S) with (1 / c_b);
        change (step.i_d S) with (1 / c_d).
      set (room := step.room S t) in *; set (hh := step.h S) in *; clearbody room hh.
      clearbody K n_a n_b n_d; repeat split.
      - transitivity ((s ^ 2 * (n_a * (1 + hh * X t ^ 2) * (1 - hh * X t ^ 2))
        + s ^ 2 * h ^ 2 * (K * (1 / c_d - 1 / c_b) * n_b * n_d * X t * Y t)) / room);
          [rewrite S2, H2 | ]; field; lra.
      - transitivity ((s ^ 2 * h ^ 2 * (n_b * (1 - hh * X t ^ 2) * Y t)
        + s ^ 2 * h ^ 2 * ((- (K * (1 / c_d - 1 / c_b)) - K * (1 / c_b - 1 / c_a))
        * n_d * n_a * (1 + hh * X t ^ 2) * X t)) / room);
          [rewrite S2, H2 | ]; field; lra.
      - transitivity ((n_d * (1 + hh * X t ^ 2) * Y t + s ^ 2 * h ^ 2 * (K * (1 / c_b - 1 / c_a)
        * n_a * n_b * (1 - hh * X t ^ 2) * X t)) / room);
          [rewrite S2, H2 | ]; field; lra. }
    destruct A as (Aa & Ab & Ad); rewrite Aa, Ab, Ad in *.
    split; apply (Rmult_eq_reg_r (/ K)); try (apply Rgt_not_eq, Rinv_0_lt_compat; lra).
    - refine (eq_trans _ Pr); field; lra.
    - refine (eq_trans _ Pi); field; lra.
  Qed.
End Step.

(* * The second half of a time: the same functions from the state in its middle. *)
Section Restart.
  Variables (h s c_a c_b c_d v_a v_b v_d : R) (X Y : R -> R) (tau : R).
  Let S := stepping h s c_a c_b c_d v_a v_b v_d X Y.
  Hypotheses (B : from_side h s c_a c_b c_d v_a v_b v_d) (E : elapsed (step.e_1 S) (step.e_2 S) X Y).
  Let w_a := step.Omega_a S tau.
  Let w_b := step.Omega_b S tau.
  Let w_d := step.Omega_d S tau.
  Let S' := stepping h s c_a c_b c_d w_a w_b w_d X Y.

  Lemma invariants : c_a * w_a ^ 2 + c_b * w_b ^ 2 + c_d * w_d ^ 2
    = c_a * v_a ^ 2 + c_b * v_b ^ 2 + c_d * v_d ^ 2 /\
    (c_a * w_a) ^ 2 + (c_b * w_b) ^ 2 + (c_d * w_d) ^ 2 = (c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2.
  Proof.
    pose proof B as [_ _ Ca Cb Cd _ _ _ _].
    pose proof (step_rates h s c_a c_b c_d v_a v_b v_d X Y B E) as R.
    destruct (step_rates_start h s c_a c_b c_d v_a v_b v_d X Y B E) as (Sa & Sb & Sd).
    pose proof (energy_kept h c_a c_b c_d Ca Cb Cd _ _ _ R tau) as L.
    pose proof (momentum_kept h c_a c_b c_d Ca Cb Cd _ _ _ R tau) as M.
    fold S in Sa, Sb, Sd, L, M; rewrite Sa, Sb, Sd in L, M; now split.
  Qed.

  Lemma middle_from_side : from_side h s c_a c_b c_d w_a w_b w_d.
  Proof.
    destruct invariants as (L & M); pose proof B as [H2 S2 Ca Cb Cd Mid C T V].
    constructor; trivial.
    - replace (c_a * (c_a - c_b) * w_a ^ 2 - c_d * (c_b - c_d) * w_d ^ 2) with
        ((c_a * w_a) ^ 2 + (c_b * w_b) ^ 2 + (c_d * w_d) ^ 2 - c_b * (c_a * w_a ^ 2 + c_b * w_b ^ 2
          + c_d * w_d ^ 2)) by ring.
      rewrite L, M; refine (Rle_trans _ _ _ C (Req_le _ _ _)); ring.
    - pose proof (kept h s c_a c_b c_d v_a v_b v_d X Y B E tau) as Q; fold S in Q.
      destruct (momentum_of_rates h s c_a c_b c_d v_a v_b v_d X Y B tau) as (Ma & _ & _); fold S w_a in Ma;
        rewrite Ma in Q.
      apply (Rmult_le_reg_l c_a); [exact Ca | lra].
    - destruct (size h s c_a c_b c_d v_a v_b v_d B) as (Kp & K2).
      pose proof (pow_lt _ 2 Kp) as P; rewrite K2, <- M in P.
      pose proof (pow2_ge_0 w_a); pose proof (pow2_ge_0 w_b); pose proof (pow2_ge_0 w_d).
      destruct (Req_dec (w_a ^ 2 + w_b ^ 2 + w_d ^ 2) 0) as [Z|Z]; [exfalso | lra].
      assert (A : w_a ^ 2 = 0 /\ w_b ^ 2 = 0 /\ w_d ^ 2 = 0) by lra.
      rewrite !Rpow_mult_distr, (proj1 A), (proj1 (proj2 A)), (proj2 (proj2 A)) in P; lra.
  Qed.

  Lemma same_constants : step.h S' = step.h S /\ step.e_1 S' = step.e_1 S /\ step.e_2 S' = step.e_2 S /\
    step.K S' = step.K S /\ step.H_0 S' = step.H_0 S.
  Proof.
    destruct invariants as (L & M); pose proof B as [H2 S2 Ca Cb Cd _ _ _ _].
    assert (by_invariants : forall x_a x_b x_d, let N := stepping h s c_a c_b c_d x_a x_b x_d X Y in
      let l := c_a * x_a ^ 2 + c_b * x_b ^ 2 + c_d * x_d ^ 2 in
      let m := (c_a * x_a) ^ 2 + (c_b * x_b) ^ 2 + (c_d * x_d) ^ 2 in
      step.h N = (c_b - c_d) * (c_a * l - m) / (4 * c_a * c_b * c_d) /\
      step.e_1 N = 2 * step.h N + (c_a - c_d) * (m - c_b * l) / (c_a * c_b * c_d) /\ step.H_0 N = l / 2).
    { intros x_a x_b x_d N l m; repeat split; [|unfold step.e_1; apply (f_equal (Rplus _)) |];
        unfold step.h, step.H_0, step.c_a, step.c_b, step.c_d, step.Omega_a0, step.Omega_b0, step.Omega_d0;
        unfold l, m; cbn -[pow]; field; lra. }
    destruct (by_invariants v_a v_b v_d) as (Hv & Ev & Lv), (by_invariants w_a w_b w_d) as (Hw & Ew & Lw).
    fold S in Hv, Ev, Lv; fold S' in Hw, Ew, Lw.
    assert (Hh : step.h S' = step.h S) by (rewrite Hv, Hw, L, M; reflexivity).
    repeat split; trivial.
    - rewrite Ev, Ew, L, M, Hh; reflexivity.
    - unfold step.e_2; now rewrite Hh.
    - cbn -[pow sqrt]; now rewrite M.
    - now rewrite Lv, Lw, L.
  Qed.

  Lemma middle_elapsed : elapsed (step.e_1 S') (step.e_2 S') X Y.
  Proof. destruct same_constants as (_ & -> & -> & _); exact E. Qed.

  Lemma shifted t : step.Omega_a S (tau + t) = step.Omega_a S' t /\
    step.Omega_b S (tau + t) = step.Omega_b S' t /\
    step.Omega_d S (tau + t) = step.Omega_d S' t.
  Proof.
    pose proof B as [_ _ Ca Cb Cd _ _ _ _].
    pose proof (step_rates h s c_a c_b c_d v_a v_b v_d X Y B E) as D; fold S in D.
    pose proof (step_rates h s c_a c_b c_d w_a w_b w_d X Y middle_from_side middle_elapsed) as D';
      fold S' in D'.
    destruct (step_rates_start h s c_a c_b c_d w_a w_b w_d X Y middle_from_side middle_elapsed)
      as (Sa & Sb & Sd).
    fold S' in Sa, Sb, Sd.
    assert (shift : forall f df : R -> R, (forall t, is_derive f t (df t)) ->
      forall t, is_derive (fun t => f (tau + t)) t (df (tau + t))).
    { intros f df F x; refine (derive_as _ _ _ _ (is_derive_comp f (fun t => tau + t) x _ 1 (F (tau + x)) _)
      _);
        [auto_derive; [easy | ring] | unfold scal; cbn; unfold mult; cbn; ring]. }
    apply (rates_unique h c_a c_b c_d Ca Cb Cd (step.Omega_a S') (step.Omega_b S') (step.Omega_d S')
      (fun t => step.Omega_a S (tau + t)) (fun t => step.Omega_b S (tau + t))
        (fun t => step.Omega_d S (tau + t)) D').
    - intros x; split; [|split].
      + apply (shift _ _ (fun t => proj1 (D t))).
      + apply (shift _ _ (fun t => proj1 (proj2 (D t)))).
      + apply (shift _ _ (fun t => proj2 (proj2 (D t)))).
    - now rewrite Rplus_0_r, Sa.
    - now rewrite Rplus_0_r, Sb.
    - now rewrite Rplus_0_r, Sd.
  Qed.

  Lemma same_turning t : step.psi_rate S (tau + t) = step.psi_rate S' t.
  Proof.
    pose proof (step_in_ledger h s c_a c_b c_d v_a v_b v_d X Y B E) as N; fold S in N.
    pose proof (step_in_ledger h s c_a c_b c_d w_a w_b w_d X Y middle_from_side middle_elapsed) as N';
      fold S' in N'.
    destruct same_constants as (_ & _ & _ & Kk & Hh), (shifted t) as (Wa & _ & _).
    unfold step.psi_rate; rewrite (step.fact_energy S N), (step.fact_energy S' N'), Hh, Wa, Kk.
    destruct (momentum_of_rates h s c_a c_b c_d v_a v_b v_d X Y B (tau + t)) as (Ma & _ & _).
    destruct (momentum_of_rates h s c_a c_b c_d w_a w_b w_d X Y middle_from_side t) as (Ma' & _ & _).
    fold S in Ma; fold S' in Ma'; rewrite Ma, Ma', Wa; reflexivity.
  Qed.

  Lemma even_and_odd t : step.J_rate S' (- t) = step.J_rate S' t /\ step.G_rate S' (- t) = - step.G_rate S' t.
  Proof.
    pose proof (direction h s c_a c_b c_d w_a w_b w_d X Y middle_from_side) as (_ & _ & _ & G).
    pose proof (functions h s c_a c_b c_d w_a w_b w_d X Y middle_from_side middle_elapsed) as F.
    pose proof (h_positive h s c_a c_b c_d w_a w_b w_d X Y middle_from_side) as P.
    destruct (backwards _ _ P G X Y F t) as (Xt & Yt).
    unfold step.J_rate, step.G_rate, step.square, step.G_re, step.G_im.
    change (step.X_ S') with X; change (step.Y S') with Y; rewrite Xt, Yt.
    replace ((- X t) ^ 2) with (X t ^ 2) by ring; split; [reflexivity|].
    unfold Rdiv; ring.
  Qed.

  Section Angle.
    Variables (J : R -> R) (J_rate : forall t, is_derive J t (step.J_rate S t)) (J_0 : J 0 = 0).
    Let angle := half_psi h s c_a c_b c_d v_a v_b v_d X Y J.
    Let part := bent h s c_a c_b c_d v_a v_b v_d X Y J.

    Lemma second_half : part (2 * tau) = 2 * part tau - atan (step.G_im S' tau / step.G_re S' tau).
    Proof.
      set (arg := fun t => atan (step.G_im S' t / step.G_re S' t)).
      pose proof (derive_half_psi h s c_a c_b c_d v_a v_b v_d X Y B E J J_rate) as D; fold S angle in D.
      pose proof (derive_argument h s c_a c_b c_d w_a w_b w_d X Y middle_from_side middle_elapsed) as A;
        fold S' in A; change (forall t, is_derive arg t (step.G_rate S' t)) in A.
      pose proof (step_in_ledger h s c_a c_b c_d w_a w_b w_d X Y middle_from_side middle_elapsed) as N';
        fold S' in N'.
      assert (Z : angle (tau + tau) + angle (tau - tau) + arg tau = angle (tau + 0) + angle (tau - 0)
        + arg 0).
      { apply (constant_in_time (fun t => angle (tau + t) + angle (tau - t) + arg t)); intros t.
        assert (D1 : is_derive (fun t => angle (tau + t)) t (step.psi_rate S (tau + t) / 2)).
        { refine (derive_as _ _ _ _ (is_derive_comp angle (fun t => tau + t) t _ 1 (D (tau + t)) _) _);
            [auto_derive; [easy | ring] | unfold scal; cbn -[step.psi_rate]; unfold mult;
              cbn -[step.psi_rate]; ring]. }
        assert (D2 : is_derive (fun t => angle (tau - t)) t (- (step.psi_rate S (tau + - t) / 2))).
        { refine (derive_as _ _ _ _ (is_derive_comp angle (fun t => tau - t) t _ (-1) (D (tau - t)) _) _);
            [auto_derive; [easy | ring] | unfold scal; cbn -[step.psi_rate]; unfold mult;
              cbn -[step.psi_rate]; unfold Rminus; ring]. }
        pose proof (A t) as D3; rewrite same_turning in D1, D2.
        rewrite (step.fact_psi_rate_of_point S' N'), (step.fact_psi S' N') in D1, D2.
        destruct (even_and_odd t) as (Ev & Od); rewrite Ev, Od in D2.
        refine (derive_as _ _ _ _ (is_derive_plus _ _ t _ _ (is_derive_plus _ _ t _ _ D1 D2) D3) _).
        unfold plus; cbn -[step.J_rate step.G_rate step.turn_0 step.K step.i_a]; field. }
      assert (arg_0 : arg 0 = 0).
      { unfold arg, step.G_im; change (step.X_ S' 0) with (X 0); rewrite (X_0 _ _ _ _ E).
        match goal with |- atan ?u = 0 => replace u with 0 by (unfold Rdiv; ring) end; apply atan_0. }
      assert (angle_0 : angle 0 = 0).
      { unfold angle, half_psi, bent.
        rewrite J_0; unfold step.G_im; change (step.X_ (stepping h s c_a c_b c_d v_a v_b v_d X Y) 0)
          with (X 0).
        rewrite (X_0 _ _ _ _ E).
        match goal with |- context [atan ?u] => replace u with 0 by (unfold Rdiv; ring) end.
        rewrite atan_0; field. }
      rewrite arg_0, Rplus_0_r, Rminus_0_r, Rminus_diag_eq, angle_0 in Z by reflexivity.
      rewrite !Rplus_0_r in Z; replace (tau + tau) with (2 * tau) in Z by ring.
      fold (arg tau); unfold angle, half_psi in Z; change (bent h s c_a c_b c_d v_a v_b v_d X Y J)
        with part in Z.
      fold S in Z; lra.
    Qed.

    (* The factor G in the middle, by what is published. *)
    Lemma factor_in_middle : step.G_re S' tau = 1 - step.h S * (step.w_im S tau ^ 2 - step.w_re S tau ^ 2)
      * X tau ^ 2 /\
      step.G_im S' tau = - (-2 * step.h S * step.w_re S tau * step.w_im S tau) * X tau ^ 2.
    Proof.
      pose proof B as [H2 S2 Ca Cb Cd _ _ _ _].
      destruct (projection h s c_a c_b c_d v_a v_b v_d X Y B E tau) as (Pr & Pi); fold S in Pr, Pi.
      destruct (momentum_of_rates h s c_a c_b c_d v_a v_b v_d X Y B tau) as (Ma & Mb & Md);
        fold S w_a w_b w_d in Ma, Mb, Md.
      destruct same_constants as (Hh & _ & _ & Kk & _); change (step.K S) with (sqrt ((c_a * v_a)
        ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2)) in Kk.
      rewrite <- Kk in Pr, Pi; rewrite Ma in Pr, Pi; rewrite Md in Pr; rewrite Mb in Pi.
      destruct (size h s c_a c_b c_d w_a w_b w_d middle_from_side) as (Kp & _).
      change (sqrt _) with (step.K S') in Kp.
      pose proof (towards _ _ _ _ _ _ _ _ middle_from_side) as T;
        pose proof (Rmult_le_pos _ _ (Rlt_le _ _ Ca) T).
      assert (Q : 0 < step.K S' + s * (c_a * w_a)) by lra.
      assert (Zr : step.z_re S' = step.w_re S tau).
      { apply (Rmult_eq_reg_r (step.K S' + s * (c_a * w_a))); [|lra]; rewrite Pr.
        change (c_d * w_d / (step.K S' + s * (c_a * w_a)) * (step.K S' + s * (c_a * w_a)) = c_d * w_d);
          field; lra. }
      assert (Zi : step.z_im S' = step.w_im S tau).
      { apply (Rmult_eq_reg_r (step.K S' + s * (c_a * w_a))); [|lra]; rewrite Pi.
        change (h * s * (c_b * w_b) / (step.K S' + s * (c_a * w_a)) * (step.K S' + s * (c_a * w_a))
          = s * h * (c_b * w_b)); field; lra. }
      unfold step.G_re, step.G_im, step.nu_re, step.nu_im; rewrite Hh, Zr, Zi.
      change (step.X_ S' tau) with (X tau); split; ring.
    Qed.
  End Angle.
End Restart.

(* * What is computed: a short time is doubled n times. *)

Lemma cosine_of_argument x y : 0 < x -> cos (atan (y / x)) = x / sqrt (x ^ 2 + y ^ 2) /\
  sin (atan (y / x)) = y / sqrt (x ^ 2 + y ^ 2).
Proof.
  intros P; rewrite cos_atan, sin_atan.
  assert (S : sqrt (1 + (y / x)²) = sqrt (x ^ 2 + y ^ 2) / x).
  { transitivity (sqrt ((x ^ 2 + y ^ 2) / x ^ 2)); [f_equal; unfold Rsqr; field; lra|].
    rewrite sqrt_div_alt, (sqrt_pow2 x) by (try apply pow_lt; lra); reflexivity. }
  pose proof (pow_lt _ 2 P); pose proof (pow2_ge_0 y).
  assert (0 < sqrt (x ^ 2 + y ^ 2)) by (apply sqrt_lt_R0; lra).
  rewrite S; split; field; lra.
Qed.

Lemma half_of_argument x y : 0 < x -> let r := sqrt (x ^ 2 + y ^ 2) in let n := sqrt (2 * r * (r + x)) in
  0 < r /\ 0 < n /\ r ^ 2 = x ^ 2 + y ^ 2 /\ n ^ 2 = 2 * r * (r + x) /\
  cos (atan (y / x) / 2) = (r + x) / n /\ sin (atan (y / x) / 2) = y / n.
Proof.
  intros P r n; destruct (cosine_of_argument x y P) as (C & D); fold r in C, D.
  pose proof (pow_lt _ 2 P); pose proof (pow2_ge_0 y).
  assert (R : 0 < r) by (apply sqrt_lt_R0; lra); assert (R2 : r ^ 2 = x ^ 2 + y ^ 2) by (apply pow2_sqrt;
    lra).
  assert (Q : 0 < 2 * r * (r + x)) by (apply Rmult_lt_0_compat; lra).
  assert (N : 0 < n) by (apply sqrt_lt_R0; lra); assert (N2 : n ^ 2 = 2 * r * (r + x)) by (apply pow2_sqrt;
    lra).
  pose proof (atan_bound (y / x)) as A; set (a := atan (y / x) / 2) in *.
  replace (atan (y / x)) with (2 * a) in C, D, A by (unfold a; field).
  assert (Cp : 0 < cos a) by (apply cos_gt_0; lra).
  rewrite cos_2a_cos in C; rewrite sin_2a in D.
  assert (Ca : cos a = (r + x) / n).
  { apply Rsqr_inj; [lra | left; apply Rdiv_lt_0_compat; lra |]; rewrite !Rsqr_pow2.
    transitivity ((r + x) ^ 2 / n ^ 2); [rewrite N2 | field; lra].
    transitivity ((x / r + 1) / 2); [rewrite <- C; field | field; lra]. }
  repeat split; trivial; apply (Rmult_eq_reg_l (2 * cos a)); [|lra].
  replace (2 * cos a * sin a) with (y / r) by (rewrite <- D; ring).
  rewrite Ca; transitivity (2 * y * (r + x) / n ^ 2); [rewrite N2|]; field; lra.
Qed.

(* X, Y and the cosine and sine of psi/2 without its linear part, at a time. *)
Record progress := Progress { at_X : R; at_Y : R; at_re : R; at_im : R }.

Section Computed.
  Variables (h s c_a c_b c_d v_a v_b v_d : R).
  Let names := stepping h s c_a c_b c_d v_a v_b v_d.
  (* The published formulas at the values x and y of X and Y. *)
  Let at_values (x y : R) := names (fun _ => x) (fun _ => y).

  (* The published sequences `projection` and `thirds`. *)
  Definition first (x y j : R) : progress :=
    let S := at_values x y in
    let square := step.G_re S 0 ^ 2 + step.G_im S 0 ^ 2 in
    let T := {| thirds.psi_0 := 0; thirds.J_rate := fun _ => 0;
      thirds.G_re := step.G_re S; thirds.G_im := step.G_im S;
      thirds.G_re_rate := fun _ => 0; thirds.G_im_rate := fun _ => 0;
      thirds.T_re := fun _ => 1; thirds.T_im := fun _ => 0;
      thirds.E_re := fun _ => cos j; thirds.E_im := fun _ => sin j;
      thirds.R_ := fun _ => sqrt square; thirds.N := fun _ => sqrt (2 * sqrt square * (sqrt square
        + step.G_re S 0)) |} in
    Progress x y (thirds.cos_half_psi T 0) (thirds.sin_half_psi T 0).

  (* The published sequences `doubling`, `projection`, `second_half`, and the sum of two angles. *)
  Definition twice (state : progress) : progress :=
    let (x, y, W_re, W_im) := state in
    let S := at_values x y in
    let D := {| doubling.e_1 := step.e_1 S; doubling.e_2 := step.e_2 S;
      doubling.X_ := fun _ => x; doubling.Y := fun _ => y |} in
    let G_re := 1 - step.h S * (step.w_im S 0 ^ 2 - step.w_re S 0 ^ 2) * x ^ 2 in
    let G_im := - (-2 * step.h S * step.w_re S 0 * step.w_im S 0) * x ^ 2 in
    let V := {| second_half.before := fun _ => 0;
      second_half.G_re := fun _ => G_re; second_half.G_im := fun _ => G_im;
      second_half.G_re_rate := fun _ => 0; second_half.G_im_rate := fun _ => 0;
      second_half.W_re := fun _ => W_re; second_half.W_im := fun _ => W_im;
      second_half.R_ := fun _ => sqrt (G_re ^ 2 + G_im ^ 2) |} in
    let V_re := second_half.V_re V 0 in
    let V_im := second_half.V_im V 0 in
    Progress (doubling.X_next D 0) (doubling.Y_next D 0) (W_re * V_re - W_im * V_im)
      (W_re * V_im + W_im * V_re).

  (* The state after a time: the published sequences `step_rates`, `state` and `constants`. *)
  Definition rates_after (state : progress) : R * R * R :=
    let S := at_values (at_X state) (at_Y state) in (step.Omega_a S 0, step.Omega_b S 0, step.Omega_d S 0).
  Definition attitude_after (p : quaternion) (t : R) (state : progress) : quaternion :=
    let S := at_values (at_X state) (at_Y state) in
    let T_re := cos (step.psi_0 S / 2 * t) in
    let T_im := sin (step.psi_0 S / 2 * t) in
    let turn := Quaternion (T_re * at_re state - T_im * at_im state)
      (s * (T_re * at_im state + T_im * at_re state)) 0 0 in
    product h (product h p (conjugate (shortest h s (step.K S) (c_a * v_a) (c_b * v_b) (c_d * v_d))))
      (product h turn (shortest h s (step.K S) (c_a * step.Omega_a S 0) (c_b * step.Omega_b S 0)
        (c_d * step.Omega_d S 0))).

  Variables (X Y : R -> R).
  Let S := names X Y.
  Hypotheses (B : from_side h s c_a c_b c_d v_a v_b v_d) (E : elapsed (step.e_1 S) (step.e_2 S) X Y).
  Variables (J : R -> R) (J_rate : forall t, is_derive J t (step.J_rate S t)) (J_0 : J 0 = 0).
  Let part := bent h s c_a c_b c_d v_a v_b v_d X Y J.
  Let progress_at t := Progress (X t) (Y t) (cos (part t)) (sin (part t)).

  Lemma first_computed t : first (X t) (Y t) (J t) = progress_at t.
  Proof.
    pose proof (G_positive h s c_a c_b c_d v_a v_b v_d X Y B E t) as P.
    change (step.G_re _ t) with (step.G_re (at_values (X t) (Y t)) 0) in P.
    destruct (half_of_argument _ (step.G_im (at_values (X t) (Y t)) 0) P) as (_ & N & _ & _ & C & D).
    unfold first, progress_at, part, bent, thirds.cos_half_psi, thirds.sin_half_psi, thirds.P_re, thirds.P_im,
      thirds.U_re, thirds.U_im.
    change (step.G_re (stepping _ _ _ _ _ _ _ _ _ _) t) with (step.G_re (at_values (X t) (Y t)) 0).
    change (step.G_im (stepping _ _ _ _ _ _ _ _ _ _) t) with (step.G_im (at_values (X t) (Y t)) 0).
    set (re := step.G_re _ 0) in *; set (im := step.G_im _ 0) in *; cbn -[pow atan]; fold re im.
    rewrite cos_minus, sin_minus, C, D; f_equal; field; lra.
  Qed.

  Lemma twice_computed t : twice (progress_at t) = progress_at (2 * t).
  Proof.
    pose proof (direction h s c_a c_b c_d v_a v_b v_d X Y B) as (_ & _ & _ & G).
    pose proof (functions h s c_a c_b c_d v_a v_b v_d X Y B E) as F.
    pose proof (h_positive h s c_a c_b c_d v_a v_b v_d X Y B) as H.
    destruct (doubled _ _ H G X Y F t) as (DX & DY).
    pose proof (second_half h s c_a c_b c_d v_a v_b v_d X Y t B E J J_rate J_0) as A.
    destruct (factor_in_middle h s c_a c_b c_d v_a v_b v_d X Y t B E) as (Re & Im).
    pose proof (G_positive h s c_a c_b c_d _ _ _ X Y (middle_from_side h s c_a c_b c_d v_a v_b v_d X Y t B E)
      (middle_elapsed h s c_a c_b c_d v_a v_b v_d X Y t B E) t) as P.
    rewrite Re, Im in A; rewrite Re in P; clear Re Im.
    unfold progress_at, twice.
    destruct (frequencies h s c_a c_b c_d v_a v_b v_d X Y B) as (_ & E1 & E2).
    f_equal.
    - rewrite DX; unfold doubling.X_next, doubling.inside; cbn [doubling.e_1 doubling.e_2 doubling.X_
      doubling.Y].
      change (step.e_2 (at_values _ _)) with (step.e_2 (stepping h s c_a c_b c_d v_a v_b v_d X Y));
        rewrite E2; reflexivity.
    - rewrite DY; unfold doubling.Y_next, doubling.inside; cbn [doubling.e_1 doubling.e_2 doubling.X_
      doubling.Y].
      change (step.e_2 (at_values _ _)) with (step.e_2 (stepping h s c_a c_b c_d v_a v_b v_d X Y)).
      change (step.e_1 (at_values _ _)) with (step.e_1 (stepping h s c_a c_b c_d v_a v_b v_d X Y));
        rewrite E1, E2; reflexivity.
    - destruct (cosine_of_argument _ (- (-2 * step.h S * step.w_re S t * step.w_im S t) * X t ^ 2) P)
      as (C & D).
      fold part in A; rewrite A; fold names; fold S; set (a := part t); cbv zeta.
      change (step.h (at_values (X t) (Y t))) with (step.h S).
      change (step.w_re (at_values (X t) (Y t)) 0) with (step.w_re S t).
      change (step.w_im (at_values (X t) (Y t)) 0) with (step.w_im S t).
      fold names in C, D; fold S in C, D; set (hh := step.h S) in *; set (wr := step.w_re S t) in *;
        set (wi := step.w_im S t) in *.
      set (b := atan _) in *; replace (2 * a - b) with (a + (a - b)) by ring.
      rewrite cos_plus, cos_minus, sin_minus, C, D.
      unfold second_half.V_re, second_half.V_im; cbn -[pow]; unfold Rdiv; ring.
    - destruct (cosine_of_argument _ (- (-2 * step.h S * step.w_re S t * step.w_im S t) * X t ^ 2) P)
      as (C & D).
      fold part in A; rewrite A; fold names; fold S; set (a := part t); cbv zeta.
      change (step.h (at_values (X t) (Y t))) with (step.h S).
      change (step.w_re (at_values (X t) (Y t)) 0) with (step.w_re S t).
      change (step.w_im (at_values (X t) (Y t)) 0) with (step.w_im S t).
      fold names in C, D; fold S in C, D; set (hh := step.h S) in *; set (wr := step.w_re S t) in *;
        set (wi := step.w_im S t) in *.
      set (b := atan _) in *; replace (2 * a - b) with (a + (a - b)) by ring.
      rewrite sin_plus, cos_minus, sin_minus, C, D.
      unfold second_half.V_re, second_half.V_im; cbn -[pow]; unfold Rdiv; ring.
  Qed.

  Lemma computed n : forall t, Nat.iter n twice (first (X (t / 2 ^ n)) (Y (t / 2 ^ n)) (J (t / 2 ^ n)))
    = progress_at t.
  Proof.
    induction n as [|n I]; intros t.
    - cbn; replace (t / 1) with t by field; apply first_computed.
    - match goal with |- Nat.iter _ _ ?x = _ => change (twice (Nat.iter n twice x) = progress_at t) end.
      replace (t / 2 ^ Datatypes.S n) with (t / 2 / 2 ^ n) by (cbn [pow]; field; apply pow_nonzero; lra).
      rewrite I, twice_computed; f_equal; field.
  Qed.

  Theorem step_by_doubling p : norm_squared p = 1 -> exists w_a w_b w_d q,
    the_motion h c_a c_b c_d v_a v_b v_d p w_a w_b w_d q /\
    forall (n : nat) (t : R),
      let state := Nat.iter n twice (first (X (t / 2 ^ n)) (Y (t / 2 ^ n)) (J (t / 2 ^ n))) in
      rates_after state = (w_a t, w_b t, w_d t) /\ attitude_after p t state = q t.
  Proof.
    intros P; do 4 eexists; split;
      [exact (step_motion h s c_a c_b c_d v_a v_b v_d X Y B E J J_rate p P)|].
    intros n t state; unfold state; rewrite computed; split; [reflexivity|].
    unfold attitude_after, from_start, pulled_back, about_a; cbn [at_X at_Y at_re at_im progress_at].
    assert (Z : half_psi h s c_a c_b c_d v_a v_b v_d X Y J 0 = 0).
    { unfold half_psi, bent; rewrite J_0; unfold step.G_im; fold names S.
      change (step.X_ S 0) with (X 0); rewrite (X_0 _ _ _ _ E).
      match goal with |- context [atan ?u] => replace u with 0 by (unfold Rdiv; ring) end.
      rewrite atan_0; field. }
    rewrite Z; replace (2 * 0 / 2) with 0 by field; rewrite cos_0, sin_0.
    destruct (step_rates_start h s c_a c_b c_d v_a v_b v_d X Y B E) as (Sa & Sb & Sd); rewrite Sa, Sb, Sd.
    apply (f_equal2 (product h)).
    - apply (f_equal2 (product h)); [reflexivity | apply (f_equal conjugate)].
      match goal with |- ?x = _ => change x with (shortest h s (sqrt ((c_a * v_a) ^ 2 + (c_b * v_b)
        ^ 2 + (c_d * v_d) ^ 2))
        (c_a * v_a) (c_b * v_b) (c_d * v_d)) end.
      destruct (shortest _ _ _ _ _ _) as [q_0 q_a q_b q_d]; unfold product; cbn; f_equal; ring.
    - apply (f_equal2 (product h)); [|reflexivity].
      replace (2 * half_psi h s c_a c_b c_d v_a v_b v_d X Y J t / 2) with (step.psi_0 S / 2 * t + part t)
        by (unfold half_psi; fold part names S; field).
      rewrite cos_plus, sin_plus; apply f_equal4; try reflexivity.
      change (step.psi_0 (at_values (X t) (Y t))) with (step.psi_0 S); ring.
  Qed.
End Computed.
