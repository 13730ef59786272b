(* Derivatives of the rates by the inputs: what the contexts `varied_rates` and `coefficients` of the
   ledger prove.

   Solutions of the equations of variation are derivatives of motions by a parameter of their moments and
   starts: the differences of two motions obey linear equations, up to terms of second order. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Rigidsym.theorems Require Import motion.
From Rigidsym.contexts Require coefficients varied_rates varied_rates_start.
Open Scope R_scope.

(* Groenwall on an interval about 0. *)
Lemma grows (e de : R -> R) (k T : R) : 0 <= k -> 0 <= e 0 ->
  (forall t, is_derive e t (de t)) -> (forall t, Rabs t <= T -> Rabs (de t) <= k * e t) ->
  forall t, Rabs t <= T -> e t <= e 0 * exp (k * T).
Proof.
  intros K Z D Bd t L.
  assert (G : forall s, s = 1 \/ s = -1 -> 0 <= s * t -> e t * exp (- k * (s * t)) <= e 0).
  { intros s S P.
    assert (F : forall x, is_derive (fun x => e (s * x) * exp (- k * x)) x
      ((s * de (s * x) - k * e (s * x)) * exp (- k * x))).
    { intros x; assert (C : is_derive (fun x => e (s * x)) x (s * de (s * x)))
        by (apply (is_derive_comp e (fun x => s * x)); [apply D | auto_derive; [easy | ring]]).
      eapply derive_as; [apply (is_derive_mult (fun x => e (s * x)) (fun x => exp (- k * x)));
        [exact C | auto_derive; [easy | reflexivity] | apply Rmult_comm] |].
      unfold plus, mult; cbn; ring. }
    destruct (between _ _ 0 (s * t) F) as (c & I & E).
    replace (s * (s * t)) with t in E by (destruct S as [-> | ->]; ring).
    rewrite !Rmult_0_r, exp_0, Rmult_1_r, Rminus_0_r in E.
    rewrite Rmin_left, Rmax_right in I by exact P.
    assert (Lc : Rabs (s * c) <= T).
    { refine (Rle_trans _ _ _ _ L); unfold Rabs; destruct S as [-> | ->]; repeat destruct Rcase_abs; lra. }
    specialize (Bd _ Lc); pose proof (exp_pos (- k * c)) as Q.
    assert (s * de (s * c) <= k * e (s * c))
      by (apply Rabs_le_between in Bd; destruct S as [-> | ->]; lra).
    assert (0 <= (k * e (s * c) - s * de (s * c)) * exp (- k * c) * (s * t))
      by (apply Rmult_le_pos; [apply Rmult_le_pos |]; lra).
    lra. }
  assert (H : forall s, s = 1 \/ s = -1 -> 0 <= s * t -> e t <= e 0 * exp (k * T)).
  { intros s S P; specialize (G s S P).
    assert (A : s * t <= T) by (apply Rabs_le_between in L; destruct S as [-> | ->]; lra).
    assert (M : exp (k * (s * t)) <= exp (k * T)).
    { destruct (Rle_lt_or_eq_dec (k * (s * t)) (k * T)) as [Q|Q]; [now apply Rmult_le_compat_l | | rewrite Q;
      lra].
      left; now apply exp_increasing. }
    assert (X : exp (- k * (s * t)) * exp (k * (s * t)) = 1)
      by (rewrite <- exp_plus; replace (_ + _) with 0 by ring; apply exp_0).
    pose proof (exp_pos (k * (s * t))) as Y.
    replace (e t) with (e t * exp (- k * (s * t)) * exp (k * (s * t))) by (rewrite Rmult_assoc, X; ring).
    refine (Rle_trans _ _ _ (Rmult_le_compat_r _ _ _ (Rlt_le _ _ Y) G) _).
    now apply Rmult_le_compat_l. }
  destruct (Rle_dec 0 t) as [P|P]; [apply (H 1) | apply (H (-1))]; auto; lra.
Qed.

(* Linear equations with bounded coefficients p, r, and a small term f. *)
Lemma linear_bound (u_a u_b u_d f_a f_b f_d p_a r_a p_b r_b p_d r_d : R -> R) (k_a k_b k_d m B T : R) :
  (forall t, is_derive u_a t (f_a t + k_a * (u_b t * p_a t + u_d t * r_a t))) ->
  (forall t, is_derive u_b t (f_b t + k_b * (u_d t * p_b t + u_a t * r_b t))) ->
  (forall t, is_derive u_d t (f_d t + k_d * (u_a t * p_d t + u_b t * r_d t))) ->
  (forall t, Rabs t <= T -> Rabs (f_a t) <= m /\ Rabs (f_b t) <= m /\ Rabs (f_d t) <= m) ->
  (forall t, Rabs (p_a t) <= B /\ Rabs (r_a t) <= B /\ Rabs (p_b t) <= B /\ Rabs (r_b t) <= B /\
    Rabs (p_d t) <= B /\ Rabs (r_d t) <= B) -> 0 <= B ->
  let N t := u_a t ^ 2 + u_b t ^ 2 + u_d t ^ 2 in
  forall t, Rabs t <= T -> N t <= (N 0 + 3 * m ^ 2) * exp ((1 + 4 * (Rabs k_a + Rabs k_b + Rabs k_d) * B)
    * T).
Proof.
  intros Da Db Dd F P Bp N t L.
  set (k := 1 + 4 * (Rabs k_a + Rabs k_b + Rabs k_d) * B).
  assert (K : 1 <= k).
  { pose proof (Rabs_pos k_a); pose proof (Rabs_pos k_b); pose proof (Rabs_pos k_d).
    assert (0 <= (Rabs k_a + Rabs k_b + Rabs k_d) * B) by (apply Rmult_le_pos; lra); unfold k; lra. }
  assert (N0 : forall t, 0 <= N t)
    by (intros x; unfold N; pose proof (pow2_ge_0 (u_a x)); pose proof (pow2_ge_0 (u_b x));
      pose proof (pow2_ge_0 (u_d x)); lra).
  pose proof (pow2_ge_0 m) as M.
  set (dN t := 2 * (u_a t * (f_a t + k_a * (u_b t * p_a t + u_d t * r_a t))
    + u_b t * (f_b t + k_b * (u_d t * p_b t + u_a t * r_b t))
      + u_d t * (f_d t + k_d * (u_a t * p_d t + u_b t * r_d t)))).
  assert (E : N t + 3 * m ^ 2 <= (N 0 + 3 * m ^ 2) * exp (k * T)).
  { apply (grows (fun t => N t + 3 * m ^ 2) dN k T); [lra | pose proof (N0 0); lra | | | exact L].
    - intros x; specialize (Da x); specialize (Db x); specialize (Dd x); unfold N, dN; derive_known; ring.
    - intros x Lx; destruct (F x Lx) as (Fa & Fb & Fd), (P x) as (Pa & Ra & Pb & Rb & Pd & Rd).
      assert (X : u_a x ^ 2 <= N x /\ u_b x ^ 2 <= N x /\ u_d x ^ 2 <= N x)
        by (unfold N; pose proof (pow2_ge_0 (u_a x)); pose proof (pow2_ge_0 (u_b x));
          pose proof (pow2_ge_0 (u_d x)); lra).
      destruct X as (Xa & Xb & Xd).
      assert (S : forall c y z w, Rabs w <= B -> y ^ 2 <= N x -> z ^ 2 <= N x ->
        - (Rabs c * (B * N x)) <= c * (y * z * w) <= Rabs c * (B * N x)) by (intros;
          now apply Rabs_le_between, term_bound).
      pose proof (S k_a _ _ _ Pa Xa Xb); pose proof (S k_a _ _ _ Ra Xa Xd); pose proof (S k_b _ _ _ Pb Xb Xd);
        pose proof (S k_b _ _ _ Rb Xb Xa); pose proof (S k_d _ _ _ Pd Xd Xa);
          pose proof (S k_d _ _ _ Rd Xd Xb).
      assert (Q : forall y f, Rabs f <= m -> - (y ^ 2 + m ^ 2) <= 2 * (y * f) <= y ^ 2 + m ^ 2).
      { intros y f Y; assert (f ^ 2 <= m ^ 2).
        { rewrite <- (pow2_abs f); pose proof (Rabs_pos f); apply pow_incr; lra. }
        pose proof (pow2_ge_0 (y + f)); pose proof (pow2_ge_0 (y - f)); lra. }
      pose proof (Q (u_a x) _ Fa); pose proof (Q (u_b x) _ Fb); pose proof (Q (u_d x) _ Fd).
      assert (0 <= 4 * (Rabs k_a + Rabs k_b + Rabs k_d) * B * (3 * m ^ 2))
        by (apply Rmult_le_pos; unfold k in K; lra).
      assert (Rabs (dN x) <= 4 * (Rabs k_a + Rabs k_b + Rabs k_d) * B * N x + N x + 3 * m ^ 2).
      { assert (Nx : N x = u_a x ^ 2 + u_b x ^ 2 + u_d x ^ 2) by reflexivity; apply Rabs_le; unfold dN; lra. }
      unfold k; lra. }
  lra.
Qed.

(* Rates that depend on a parameter e: alpha are the coefficients of Euler's equations, y are solutions of
   the equations of variation. *)
Section Variation.
  Variables (alpha_a alpha_b alpha_d : R -> R) (d_a d_b d_d : R) (w_a w_b w_d : R -> R -> R).
  Variables (y_a y_b y_d : R -> R) (B reach : R).
  Hypotheses (Alpha_a : is_derive alpha_a 0 d_a) (Alpha_b : is_derive alpha_b 0 d_b)
    (Alpha_d : is_derive alpha_d 0 d_d).
  Hypothesis near : 0 < reach.
  Hypothesis W_a : forall e t, Rabs e < reach -> is_derive (w_a e) t (alpha_a e * w_b e t * w_d e t).
  Hypothesis W_b : forall e t, Rabs e < reach -> is_derive (w_b e) t (alpha_b e * w_d e t * w_a e t).
  Hypothesis W_d : forall e t, Rabs e < reach -> is_derive (w_d e) t (alpha_d e * w_a e t * w_b e t).
  Hypothesis bounded : forall e t, Rabs e < reach -> Rabs (w_a e t) <= B /\ Rabs (w_b e t) <= B /\
    Rabs (w_d e t) <= B.
  Hypothesis start : forall e, Rabs e < reach ->
    w_a e 0 = w_a 0 0 + e * y_a 0 /\ w_b e 0 = w_b 0 0 + e * y_b 0 /\ w_d e 0 = w_d 0 0 + e * y_d 0.
  Hypothesis Y_a : forall t, is_derive y_a t (d_a * w_b 0 t * w_d 0 t + alpha_a 0 * (y_b t * w_d 0 t
    + w_b 0 t * y_d t)).
  Hypothesis Y_b : forall t, is_derive y_b t (d_b * w_d 0 t * w_a 0 t + alpha_b 0 * (y_d t * w_a 0 t
    + w_d 0 t * y_a t)).
  Hypothesis Y_d : forall t, is_derive y_d t (d_d * w_a 0 t * w_b 0 t + alpha_d 0 * (y_a t * w_b 0 t
    + w_a 0 t * y_b t)).

  Let A := Rabs (alpha_a 0) + Rabs (alpha_b 0) + Rabs (alpha_d 0).
  Let L := Rabs d_a + Rabs d_b + Rabs d_d + 1.
  Let growth T := exp ((1 + 4 * A * B) * T).
  Let N0 := y_a 0 ^ 2 + y_b 0 ^ 2 + y_d 0 ^ 2.
  (* Differences of motions are at most root T times e. *)
  Let square T := (N0 + 3 * (L * B ^ 2) ^ 2) * growth T.

  Lemma B_positive : 0 <= B.
  Proof.
    destruct (bounded 0 0) as (P & _); [now rewrite Rabs_R0|]; pose proof (Rabs_pos (w_a 0 0)); lra.
  Qed.

  Lemma growth_positive T : 0 < growth T.
  Proof. apply exp_pos. Qed.

  (* What is left of alpha beyond its derivative is smaller than any multiple of e. *)
  Lemma remainder (alpha : R -> R) d : is_derive alpha 0 d -> forall eta, 0 < eta ->
    exists delta, 0 < delta /\ forall e, Rabs e < delta -> Rabs (alpha e - alpha 0 - e * d) <= eta * Rabs e.
  Proof.
    intros D eta H; apply is_derive_Reals in D; destruct (D eta H) as (delta & P).
    exists delta; split; [apply cond_pos|]; intros e E.
    destruct (Req_dec e 0) as [->|N]; [rewrite Rmult_0_l, Rminus_0_r, Rminus_diag_eq, Rabs_R0 by easy; lra|].
    specialize (P e N E); rewrite Rplus_0_l in P.
    replace (alpha e - alpha 0 - e * d) with (((alpha e - alpha 0) / e - d) * e) by (field; exact N).
    rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos | lra].
  Qed.

  Section At.
    Variables (e eta T : R).
    Hypotheses (E : Rabs e < reach) (Eta : 0 < eta <= 1).
    Hypotheses (Ra : Rabs (alpha_a e - alpha_a 0 - e * d_a) <= eta * Rabs e)
      (Rb : Rabs (alpha_b e - alpha_b 0 - e * d_b) <= eta * Rabs e)
      (Rd : Rabs (alpha_d e - alpha_d 0 - e * d_d) <= eta * Rabs e).

    Lemma product3 x y z X Y Z : Rabs x <= X -> Rabs y <= Y -> Rabs z <= Z -> Rabs (x * y * z) <= X * Y * Z.
    Proof.
      intros; rewrite !Rabs_mult; repeat apply Rmult_le_compat; repeat apply Rmult_le_pos; trivial;
        apply Rabs_pos.
    Qed.

    Lemma alphas : Rabs (alpha_a e - alpha_a 0) <= L * Rabs e /\ Rabs (alpha_b e - alpha_b 0) <= L * Rabs e /\
      Rabs (alpha_d e - alpha_d 0) <= L * Rabs e.
    Proof.
      pose proof (Rabs_pos e); pose proof (Rabs_pos d_a); pose proof (Rabs_pos d_b);
        pose proof (Rabs_pos d_d).
      assert (S : forall x d, Rabs (x - e * d) <= eta * Rabs e -> Rabs d <= L - 1 -> Rabs x <= L * Rabs e).
      { intros x d X D; replace x with ((x - e * d) + e * d) by ring.
        eapply Rle_trans; [apply Rabs_triang|]; rewrite (Rabs_mult e d); nra. }
      repeat split; [apply (S _ d_a) | apply (S _ d_b) | apply (S _ d_d)]; trivial; unfold L; lra.
    Qed.

    Lemma differences : forall t, Rabs t <= T ->
      (w_a e t - w_a 0 t) ^ 2 + (w_b e t - w_b 0 t) ^ 2 + (w_d e t - w_d 0 t) ^ 2 <= square T * Rabs e ^ 2.
    Proof.
      pose proof B_positive as Bp; destruct alphas as (La & Lb & Ld).
      assert (O : Rabs 0 < reach) by now rewrite Rabs_R0.
      pose proof (fun t => bounded e t E) as We; pose proof (fun t => bounded 0 t O) as W0.
      intros t Lt; pose proof (linear_bound (fun t => w_a e t - w_a 0 t) (fun t => w_b e t - w_b 0 t)
        (fun t => w_d e t - w_d 0 t)
        (fun t => (alpha_a e - alpha_a 0) * w_b e t * w_d e t) (fun t => (alpha_b e - alpha_b 0)
          * w_d e t * w_a e t)
        (fun t => (alpha_d e - alpha_d 0) * w_a e t * w_b e t)
        (w_d e) (w_b 0) (w_a e) (w_d 0) (w_b e) (w_a 0) (alpha_a 0) (alpha_b 0) (alpha_d 0)
          (L * Rabs e * B * B) B T) as G.
      cbv beta zeta in G; refine (Rle_trans _ _ _ (G _ _ _ _ _ Bp t Lt) _); clear G.
      - intros x; pose proof (W_a e x E) as D; pose proof (W_a 0 x O) as D0.
        refine (derive_as _ _ _ _ (derive_difference _ _ _ _ _ D D0) _); ring.
      - intros x; pose proof (W_b e x E) as D; pose proof (W_b 0 x O) as D0.
        refine (derive_as _ _ _ _ (derive_difference _ _ _ _ _ D D0) _); ring.
      - intros x; pose proof (W_d e x E) as D; pose proof (W_d 0 x O) as D0.
        refine (derive_as _ _ _ _ (derive_difference _ _ _ _ _ D D0) _); ring.
      - intros x _; destruct (We x) as (? & ? & ?); repeat split; now apply product3.
      - intros x; destruct (We x) as (? & ? & ?), (W0 x) as (? & ? & ?); repeat split; assumption.
      - destruct (start e E) as (-> & -> & ->); unfold square, N0, growth, A; rewrite pow2_abs.
        match goal with |- _ * ?g <= _ => set (k := g) end; right; rewrite <- (pow2_abs e); ring_simplify.
        rewrite !pow2_abs; ring.
    Qed.

    (* The differences beyond e times y. *)
    Let D := sqrt (square T).
    Let rho := Rabs e * (eta * B ^ 2 + (2 * L * B * D + A * D ^ 2) * Rabs e).
    Lemma errors t : Rabs t <= T ->
      (w_a e t - w_a 0 t - e * y_a t) ^ 2 + (w_b e t - w_b 0 t - e * y_b t)
        ^ 2 + (w_d e t - w_d 0 t - e * y_d t) ^ 2
        <= 3 * growth T * rho ^ 2.
    Proof.
      pose proof B_positive as Bp; destruct alphas as (La & Lb & Ld); pose proof (Rabs_pos e) as Ep.
      assert (O : Rabs 0 < reach) by now rewrite Rabs_R0.
      pose proof (fun t => bounded e t E) as We; pose proof (fun t => bounded 0 t O) as W0.
      assert (Sp : 0 <= square T).
      { unfold square; apply Rmult_le_pos; [|left; apply growth_positive]; unfold N0.
        pose proof (pow2_ge_0 (y_a 0)); pose proof (pow2_ge_0 (y_b 0)); pose proof (pow2_ge_0 (y_d 0));
          pose proof (pow2_ge_0 (L * B ^ 2)); lra. }
      assert (Dp : 0 <= D) by apply sqrt_pos; assert (D2 : D ^ 2 = square T) by now apply pow2_sqrt.
      assert (Lp : 0 <= L) by (unfold L; pose proof (Rabs_pos d_a); pose proof (Rabs_pos d_b);
        pose proof (Rabs_pos d_d); lra).
      assert (small : forall x t, Rabs t <= T -> x ^ 2 <= square T * Rabs e ^ 2 -> Rabs x <= D * Rabs e).
      { intros x y _ X; apply Rabs_le; assert (P : 0 <= D * Rabs e) by now apply Rmult_le_pos.
        rewrite <- D2 in X; replace (D ^ 2 * Rabs e ^ 2) with ((D * Rabs e) ^ 2) in X by ring.
        clearbody D; split; nra. }
      assert (apart : forall x, Rabs x <= T -> Rabs (w_a e x - w_a 0 x) <= D * Rabs e /\
        Rabs (w_b e x - w_b 0 x) <= D * Rabs e /\ Rabs (w_d e x - w_d 0 x) <= D * Rabs e).
      { intros x X; pose proof (differences x X) as Q.
        pose proof (pow2_ge_0 (w_a e x - w_a 0 x)); pose proof (pow2_ge_0 (w_b e x - w_b 0 x));
          pose proof (pow2_ge_0 (w_d e x - w_d 0 x)).
        repeat split; apply (small _ x X); lra. }
      assert (Alphas : Rabs (alpha_a 0) <= A /\ Rabs (alpha_b 0) <= A /\ Rabs (alpha_d 0) <= A)
        by (unfold A; pose proof (Rabs_pos (alpha_a 0)); pose proof (Rabs_pos (alpha_b 0));
          pose proof (Rabs_pos (alpha_d 0)); lra).
      (* One of the terms f. *)
      assert (term : forall r a k x1 x2 w1 w2, Rabs r <= eta * Rabs e -> Rabs a <= L * Rabs e ->
        Rabs k <= A ->
        Rabs x2 <= B -> Rabs w1 <= B -> Rabs w2 <= B -> Rabs (x1 - w1) <= D * Rabs e ->
          Rabs (x2 - w2) <= D * Rabs e ->
        Rabs (r * w1 * w2 + a * (x1 - w1) * x2 + a * w1 * (x2 - w2) + k * (x1 - w1) * (x2 - w2)) <= rho).
      { intros r a k x1 x2 w1 w2 Hr Ha Hk X2 W1 W2 G1 G2.
        pose proof (product3 _ _ _ _ _ _ Hr W1 W2); pose proof (product3 _ _ _ _ _ _ Ha G1 X2);
          pose proof (product3 _ _ _ _ _ _ Ha W1 G2); pose proof (product3 _ _ _ _ _ _ Hk G1 G2).
        repeat match goal with H : Rabs (_ * _ * _) <= _ |- _ => apply Rabs_le_between in H end.
        apply Rabs_le; unfold rho; lra. }
      intros Lt.
      pose proof (linear_bound (fun t => w_a e t - w_a 0 t - e * y_a t)
        (fun t => w_b e t - w_b 0 t - e * y_b t)
        (fun t => w_d e t - w_d 0 t - e * y_d t)
        (fun t => (alpha_a e - alpha_a 0 - e * d_a) * w_b 0 t * w_d 0 t + (alpha_a e - alpha_a 0)
          * (w_b e t - w_b 0 t) * w_d e t
          + (alpha_a e - alpha_a 0) * w_b 0 t * (w_d e t - w_d 0 t) + alpha_a 0 * (w_b e t - w_b 0 t)
            * (w_d e t - w_d 0 t))
        (fun t => (alpha_b e - alpha_b 0 - e * d_b) * w_d 0 t * w_a 0 t + (alpha_b e - alpha_b 0)
          * (w_d e t - w_d 0 t) * w_a e t
          + (alpha_b e - alpha_b 0) * w_d 0 t * (w_a e t - w_a 0 t) + alpha_b 0 * (w_d e t - w_d 0 t)
            * (w_a e t - w_a 0 t))
        (fun t => (alpha_d e - alpha_d 0 - e * d_d) * w_a 0 t * w_b 0 t + (alpha_d e - alpha_d 0)
          * (w_a e t - w_a 0 t) * w_b e t
          + (alpha_d e - alpha_d 0) * w_a 0 t * (w_b e t - w_b 0 t) + alpha_d 0 * (w_a e t - w_a 0 t)
            * (w_b e t - w_b 0 t))
        (w_d 0) (w_b 0) (w_a 0) (w_d 0) (w_b 0) (w_a 0) (alpha_a 0) (alpha_b 0) (alpha_d 0) rho B T) as G.
      cbv beta zeta in G; refine (Rle_trans _ _ _ (G _ _ _ _ _ Bp t Lt) _); clear G.
      - intros x; pose proof (W_a e x E) as F; pose proof (W_a 0 x O) as F0; pose proof (Y_a x).
        pose proof (derive_difference _ _ _ _ _ F F0); derive_known; ring.
      - intros x; pose proof (W_b e x E) as F; pose proof (W_b 0 x O) as F0; pose proof (Y_b x).
        pose proof (derive_difference _ _ _ _ _ F F0); derive_known; ring.
      - intros x; pose proof (W_d e x E) as F; pose proof (W_d 0 x O) as F0; pose proof (Y_d x).
        pose proof (derive_difference _ _ _ _ _ F F0); derive_known; ring.
      - intros x X; destruct (We x) as (? & ? & ?), (W0 x) as (? & ? & ?), (apart x X) as (? & ? & ?),
        Alphas as (? & ? & ?).
        repeat split; now apply term.
      - intros x; destruct (W0 x) as (? & ? & ?); repeat split; assumption.
      - destruct (start e E) as (Ea & Eb & Ed); rewrite Ea, Eb, Ed; unfold growth, A; right; ring.
    Qed.
  End At.

  Lemma derivative_of_a t : is_derive (fun e => w_a e t) 0 (y_a t).
  Proof.
    set (T := Rabs t).
    set (D := sqrt (square T)); set (C := 2 * L * B * D + A * D ^ 2); set (G := sqrt (3 * growth T)).
    pose proof (growth_positive T) as Gp; pose proof B_positive as Bp.
    assert (G2 : G ^ 2 = 3 * growth T) by (apply pow2_sqrt; lra).
    assert (G0 : 0 <= G) by apply sqrt_pos.
    assert (C0 : 0 <= C).
    { assert (0 <= D) by apply sqrt_pos.
      assert (0 <= L) by (unfold L; pose proof (Rabs_pos d_a); pose proof (Rabs_pos d_b);
        pose proof (Rabs_pos d_d); lra).
      assert (0 <= A) by (unfold A; pose proof (Rabs_pos (alpha_a 0)); pose proof (Rabs_pos (alpha_b 0));
        pose proof (Rabs_pos (alpha_d 0)); lra).
      pose proof (Rmult_le_pos _ _ (Rmult_le_pos _ _ H0 Bp) H);
        pose proof (Rmult_le_pos _ _ H1 (pow2_ge_0 D)); unfold C; lra. }
    apply is_derive_Reals; intros eps Eps.
    set (eta := Rmin 1 (eps / (2 * (G * B ^ 2 + 1)))).
    assert (GB : 0 <= G * B ^ 2) by (apply Rmult_le_pos; [assumption | apply pow2_ge_0]).
    assert (Eta : 0 < eta <= 1).
    { unfold eta; split; [apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; lra] | apply Rmin_l]. }
    assert (Small : eta * (G * B ^ 2) < eps / 2).
    { apply Rle_lt_trans with (eps / (2 * (G * B ^ 2 + 1)) * (G * B ^ 2));
        [apply Rmult_le_compat_r; [assumption | apply Rmin_r]|].
      replace (eps / 2) with (eps / (2 * (G * B ^ 2 + 1)) * (G * B ^ 2 + 1)) by (field; lra).
      apply Rmult_lt_compat_l; [apply Rdiv_lt_0_compat|]; lra. }
    destruct (remainder alpha_a d_a Alpha_a eta (proj1 Eta)) as (da & Da & Ra).
    destruct (remainder alpha_b d_b Alpha_b eta (proj1 Eta)) as (db & Db & Rb).
    destruct (remainder alpha_d d_d Alpha_d eta (proj1 Eta)) as (dd & Dd & Rd).
    set (de := eps / (2 * (G * C + 1))).
    assert (GC : 0 <= G * C) by now apply Rmult_le_pos.
    assert (De : 0 < de) by (apply Rdiv_lt_0_compat; lra).
    set (delta := Rmin (Rmin reach de) (Rmin da (Rmin db dd))).
    assert (Dp : 0 < delta) by (unfold delta; repeat apply Rmin_pos; assumption).
    exists (mkposreal delta Dp); intros e N E; cbn in E; rewrite Rplus_0_l.
    assert (Q : Rabs e < reach /\ Rabs e < de /\ Rabs e < da /\ Rabs e < db /\ Rabs e < dd).
    { unfold delta in E; repeat split; eapply Rlt_le_trans; try exact E.
      - eapply Rle_trans; apply Rmin_l.
      - eapply Rle_trans; [apply Rmin_l | apply Rmin_r].
      - eapply Rle_trans; [apply Rmin_r | apply Rmin_l].
      - eapply Rle_trans; [apply Rmin_r | eapply Rle_trans; [apply Rmin_r | apply Rmin_l]].
      - eapply Rle_trans; [apply Rmin_r | eapply Rle_trans; [apply Rmin_r | apply Rmin_r]]. }
    destruct Q as (Qr & Qe & Qa & Qb & Qd).
    pose proof (errors e eta T Qr Eta (Ra e Qa) (Rb e Qb) (Rd e Qd) t (Rle_refl _)) as F.
    fold D in F; fold C in F; rewrite <- G2 in F.
    pose proof (pow2_ge_0 (w_b e t - w_b 0 t - e * y_b t)); pose proof (pow2_ge_0 (w_d e t - w_d 0 t
      - e * y_d t)).
    set (x := w_a e t - w_a 0 t - e * y_a t) in *.
    assert (X : Rabs x <= Rabs e * (G * (eta * B ^ 2 + C * Rabs e))).
    { assert (P : 0 <= Rabs e * (G * (eta * B ^ 2 + C * Rabs e))).
      { pose proof (Rabs_pos e); apply Rmult_le_pos; [assumption|]; apply Rmult_le_pos; [assumption|].
        apply Rplus_le_le_0_compat; apply Rmult_le_pos; try assumption; [lra | apply pow2_ge_0]. }
      assert (x ^ 2 <= (Rabs e * (G * (eta * B ^ 2 + C * Rabs e))) ^ 2)
        by (refine (Rle_trans _ _ _ _ (Rle_trans _ _ _ F (Req_le _ _ _))); [lra | ring]).
      apply Rabs_le; set (z := Rabs e * _) in *; clearbody z; split; nra. }
    replace ((w_a e t - w_a 0 t) / e - y_a t) with (x / e) by (unfold x; field; exact N).
    assert (Ne : 0 < Rabs e) by now apply Rabs_pos_lt.
    unfold Rdiv; rewrite Rabs_mult, Rabs_inv; apply (Rmult_lt_reg_r (Rabs e)); [exact Ne|].
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; refine (Rle_lt_trans _ _ _ X _).
    rewrite (Rmult_comm eps); apply Rmult_lt_compat_l; [exact Ne|].
    assert (G * C * Rabs e < eps / 2).
    { apply Rle_lt_trans with (G * C * de); [apply Rmult_le_compat_l; lra|]; unfold de.
      replace (eps / 2) with ((G * C + 1) * (eps / (2 * (G * C + 1)))) by (field; lra).
      apply Rmult_lt_compat_r; [exact De | lra]. }
    lra.
  Qed.
End Variation.

(* * Motions *)

(* A body and its start at a parameter e. *)
Record family (h c_a c_b c_d v_a v_b v_d dc_a dc_b dc_d dv_a dv_b dv_d reach : R) (u_a u_b u_d : R -> R ->
  R) : Prop := Family {
  family_rates : forall e, Rabs e < reach ->
    euler h (c_a + e * dc_a) (c_b + e * dc_b) (c_d + e * dc_d) (u_a e) (u_b e) (u_d e);
  family_start : forall e, Rabs e < reach ->
    u_a e 0 = v_a + e * dv_a /\ u_b e 0 = v_b + e * dv_b /\ u_d e 0 = v_d + e * dv_d
}.

(* What the ledger calls the columns, in any direction: the published derivatives by each input. *)
Definition column_a (X : varied_rates.names) (dc_a dc_b dc_d dv_a dv_b dv_d t : R) : R :=
  dv_a * varied_rates.Omega_a_by_Omega_a X t + dv_b * varied_rates.Omega_a_by_Omega_b X t
  + dv_d * varied_rates.Omega_a_by_Omega_d X t + dc_a * varied_rates.Omega_a_by_c_a X t
  + dc_b * varied_rates.Omega_a_by_c_b X t + dc_d * varied_rates.Omega_a_by_c_d X t.
Definition column_b (X : varied_rates.names) (dc_a dc_b dc_d dv_a dv_b dv_d t : R) : R :=
  dv_a * varied_rates.Omega_b_by_Omega_a X t + dv_b * varied_rates.Omega_b_by_Omega_b X t
  + dv_d * varied_rates.Omega_b_by_Omega_d X t + dc_a * varied_rates.Omega_b_by_c_a X t
  + dc_b * varied_rates.Omega_b_by_c_b X t + dc_d * varied_rates.Omega_b_by_c_d X t.
Definition column_d (X : varied_rates.names) (dc_a dc_b dc_d dv_a dv_b dv_d t : R) : R :=
  dv_a * varied_rates.Omega_d_by_Omega_a X t + dv_b * varied_rates.Omega_d_by_Omega_b X t
  + dv_d * varied_rates.Omega_d_by_Omega_d X t + dc_a * varied_rates.Omega_d_by_c_a X t
  + dc_b * varied_rates.Omega_d_by_c_b X t + dc_d * varied_rates.Omega_d_by_c_d X t.

Lemma derive_combination (f_1 f_2 f_3 f_4 f_5 f_6 : R -> R) (x d_1 d_2 d_3 d_4 d_5 d_6 a_1 a_2 a_3 a_4 a_5
  a_6 : R) :
  is_derive f_1 x d_1 -> is_derive f_2 x d_2 -> is_derive f_3 x d_3 -> is_derive f_4 x d_4 ->
    is_derive f_5 x d_5 ->
  is_derive f_6 x d_6 ->
  is_derive (fun t => a_1 * f_1 t + a_2 * f_2 t + a_3 * f_3 t + a_4 * f_4 t + a_5 * f_5 t + a_6 * f_6 t) x
    (a_1 * d_1 + a_2 * d_2 + a_3 * d_3 + a_4 * d_4 + a_5 * d_5 + a_6 * d_6).
Proof. intros; derive_known; ring. Qed.

Section Columns.
  Variables (h c_a c_b c_d v_a v_b v_d : R) (S_t C_t D_t E_t F_t : R -> R).
  Let C := {| coefficients.epsilon := h; coefficients.c_a := c_a; coefficients.c_b := c_b;
    coefficients.c_d := c_d;
    coefficients.Omega_a0 := v_a; coefficients.Omega_b0 := v_b; coefficients.Omega_d0 := v_d;
    coefficients.h1 := 0; coefficients.h2 := 0; coefficients.h3 := 0 |}.
  (* The names of the ledger. *)
  Definition columns : varied_rates.names := {|
    varied_rates.alpha_a := coefficients.alpha_a C; varied_rates.alpha_b := coefficients.alpha_b C;
    varied_rates.alpha_d := coefficients.alpha_d C;
    varied_rates.alpha_a_by_c_a := coefficients.alpha_a_by_c_a C;
      varied_rates.alpha_a_by_c_b := coefficients.alpha_a_by_c_b C;
    varied_rates.alpha_a_by_c_d := coefficients.alpha_a_by_c_d C;
    varied_rates.alpha_b_by_c_a := coefficients.alpha_b_by_c_a C;
      varied_rates.alpha_b_by_c_b := coefficients.alpha_b_by_c_b C;
    varied_rates.alpha_b_by_c_d := coefficients.alpha_b_by_c_d C;
    varied_rates.alpha_d_by_c_a := coefficients.alpha_d_by_c_a C;
      varied_rates.alpha_d_by_c_b := coefficients.alpha_d_by_c_b C;
    varied_rates.alpha_d_by_c_d := coefficients.alpha_d_by_c_d C;
    varied_rates.Omega_a0 := v_a; varied_rates.Omega_b0 := v_b; varied_rates.Omega_d0 := v_d;
    varied_rates.S_t := S_t; varied_rates.C_t := C_t; varied_rates.D_t := D_t; varied_rates.t_ := fun t => t;
    varied_rates.E_t := E_t; varied_rates.F_t := F_t |}.
  Let X := columns.
  Hypotheses (Ca : 0 < c_a) (Cb : 0 < c_b) (Cd : 0 < c_d) (H : varied_rates.holds X).
  Hypotheses (S_0 : S_t 0 = 0) (C_0 : C_t 0 = 1) (D_0 : D_t 0 = 1) (E_0 : E_t 0 = 0) (F_0 : F_t 0 = 0).
  Variables (dc_a dc_b dc_d dv_a dv_b dv_d reach : R) (u_a u_b u_d : R -> R -> R).
  Hypotheses (Reach : 0 < reach)
    (U : family h c_a c_b c_d v_a v_b v_d dc_a dc_b dc_d dv_a dv_b dv_d reach u_a u_b u_d).

  Let alpha_a e := h * ((c_b + e * dc_b) - (c_d + e * dc_d)) / (c_a + e * dc_a).
  Let alpha_b e := h * ((c_d + e * dc_d) - (c_a + e * dc_a)) / (c_b + e * dc_b).
  Let alpha_d e := h * ((c_a + e * dc_a) - (c_b + e * dc_b)) / (c_d + e * dc_d).
  Let d_a := dc_a * coefficients.alpha_a_by_c_a C + dc_b * coefficients.alpha_a_by_c_b C
    + dc_d * coefficients.alpha_a_by_c_d C.
  Let d_b := dc_a * coefficients.alpha_b_by_c_a C + dc_b * coefficients.alpha_b_by_c_b C
    + dc_d * coefficients.alpha_b_by_c_d C.
  Let d_d := dc_a * coefficients.alpha_d_by_c_a C + dc_b * coefficients.alpha_d_by_c_b C
    + dc_d * coefficients.alpha_d_by_c_d C.
  Let y_a := column_a X dc_a dc_b dc_d dv_a dv_b dv_d.
  Let y_b := column_b X dc_a dc_b dc_d dv_a dv_b dv_d.
  Let y_d := column_d X dc_a dc_b dc_d dv_a dv_b dv_d.

  Lemma alphas_derive : is_derive alpha_a 0 d_a /\ is_derive alpha_b 0 d_b /\ is_derive alpha_d 0 d_d.
  Proof.
    unfold alpha_a, alpha_b, alpha_d, d_a, d_b, d_d, coefficients.alpha_a_by_c_a, coefficients.alpha_a_by_c_b,
      coefficients.alpha_a_by_c_d, coefficients.alpha_b_by_c_a, coefficients.alpha_b_by_c_b,
        coefficients.alpha_b_by_c_d,
      coefficients.alpha_d_by_c_a, coefficients.alpha_d_by_c_b, coefficients.alpha_d_by_c_d,
        coefficients.alpha_a,
      coefficients.alpha_b, coefficients.alpha_d, coefficients.c_ab, coefficients.c_ad, coefficients.c_bd;
        cbn.
    split; [|split]; auto_derive; try (field; lra); rewrite Rmult_0_l, Rplus_0_r; lra.
  Qed.

  Lemma at_start : (varied_rates.Omega_a X 0 = v_a /\ varied_rates.Omega_b X 0 = v_b /\
    varied_rates.Omega_d X 0 = v_d) /\
    y_a 0 = dv_a /\ y_b 0 = dv_b /\ y_d 0 = dv_d.
  Proof.
    set (Z := {| varied_rates_start.alpha_a := coefficients.alpha_a C;
      varied_rates_start.alpha_b := coefficients.alpha_b C;
      varied_rates_start.alpha_d := coefficients.alpha_d C;
      varied_rates_start.alpha_a_by_c_a := coefficients.alpha_a_by_c_a C;
        varied_rates_start.alpha_a_by_c_b := coefficients.alpha_a_by_c_b C;
      varied_rates_start.alpha_a_by_c_d := coefficients.alpha_a_by_c_d C;
      varied_rates_start.alpha_b_by_c_a := coefficients.alpha_b_by_c_a C;
        varied_rates_start.alpha_b_by_c_b := coefficients.alpha_b_by_c_b C;
      varied_rates_start.alpha_b_by_c_d := coefficients.alpha_b_by_c_d C;
      varied_rates_start.alpha_d_by_c_a := coefficients.alpha_d_by_c_a C;
        varied_rates_start.alpha_d_by_c_b := coefficients.alpha_d_by_c_b C;
      varied_rates_start.alpha_d_by_c_d := coefficients.alpha_d_by_c_d C;
      varied_rates_start.Omega_a0 := v_a; varied_rates_start.Omega_b0 := v_b;
        varied_rates_start.Omega_d0 := v_d;
      varied_rates_start.S_t := S_t 0; varied_rates_start.C_t := C_t 0; varied_rates_start.D_t := D_t 0;
        varied_rates_start.t_ := 0;
      varied_rates_start.E_t := E_t 0; varied_rates_start.F_t := F_t 0 |}).
    assert (HZ : varied_rates_start.holds Z).
    { constructor; [exact (varied_rates.unit_0 X H 0) | exact (varied_rates.unit_1 X H 0) | cbn; lra ..]. }
    destruct (varied_rates_start.fact_rates Z HZ) as (A & B & D & aa & ba & da & ab & bb & db & ad & bd & dd
      & ac & bc & dc & ac' & bc' & dc' & ac'' & bc'' & dc'' & _).
    change (varied_rates.Omega_a X 0) with (varied_rates_start.Omega_a Z).
    change (varied_rates.Omega_b X 0) with (varied_rates_start.Omega_b Z).
    change (varied_rates.Omega_d X 0) with (varied_rates_start.Omega_d Z).
    change (y_a 0) with (dv_a * varied_rates_start.Omega_a_by_Omega_a Z
      + dv_b * varied_rates_start.Omega_a_by_Omega_b Z
      + dv_d * varied_rates_start.Omega_a_by_Omega_d Z + dc_a * varied_rates_start.Omega_a_by_c_a Z
      + dc_b * varied_rates_start.Omega_a_by_c_b Z + dc_d * varied_rates_start.Omega_a_by_c_d Z).
    change (y_b 0) with (dv_a * varied_rates_start.Omega_b_by_Omega_a Z
      + dv_b * varied_rates_start.Omega_b_by_Omega_b Z
      + dv_d * varied_rates_start.Omega_b_by_Omega_d Z + dc_a * varied_rates_start.Omega_b_by_c_a Z
      + dc_b * varied_rates_start.Omega_b_by_c_b Z + dc_d * varied_rates_start.Omega_b_by_c_d Z).
    change (y_d 0) with (dv_a * varied_rates_start.Omega_d_by_Omega_a Z
      + dv_b * varied_rates_start.Omega_d_by_Omega_b Z
      + dv_d * varied_rates_start.Omega_d_by_Omega_d Z + dc_a * varied_rates_start.Omega_d_by_c_a Z
      + dc_b * varied_rates_start.Omega_d_by_c_b Z + dc_d * varied_rates_start.Omega_d_by_c_d Z).
    rewrite A, B, D, aa, ba, da, ab, bb, db, ad, bd, dd, ac, bc, dc, ac', bc', dc', ac'', bc'', dc''.
    repeat split; ring.
  Qed.

  (* At e = 0 the family is the published motion. *)
  Lemma middle_member t : u_a 0 t = varied_rates.Omega_a X t /\ u_b 0 t = varied_rates.Omega_b X t /\
    u_d 0 t = varied_rates.Omega_d X t.
  Proof.
    assert (O : Rabs 0 < reach) by now rewrite Rabs_R0.
    destruct (family_start _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ U 0 O) as (Sa & Sb & Sd).
    pose proof (family_rates _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ U 0 O) as R.
    assert (Z : forall x y, x + 0 * y = x) by (intros; ring); repeat rewrite Z in R; rewrite Z in Sa, Sb, Sd.
    destruct at_start as ((Oa & Ob & Od) & _).
    apply (rates_unique h c_a c_b c_d Ca Cb Cd (varied_rates.Omega_a X) (varied_rates.Omega_b X)
      (varied_rates.Omega_d X) (u_a 0) (u_b 0) (u_d 0));
      [|exact R | congruence | congruence | congruence].
    intros x; destruct (varied_rates.fact_euler X H x) as (Da & Db & Dd); split; [|split];
      [refine (derive_as _ _ _ _ Da _) | refine (derive_as _ _ _ _ Db _) | refine (derive_as _ _ _ _ Dd _)];
      unfold varied_rates.alpha_a, varied_rates.alpha_b, varied_rates.alpha_d;
      cbn -[varied_rates.Omega_a varied_rates.Omega_b varied_rates.Omega_d];
      unfold coefficients.alpha_a, coefficients.alpha_b, coefficients.alpha_d, coefficients.c_ab,
        coefficients.c_ad, coefficients.c_bd;
      cbn -[varied_rates.Omega_a varied_rates.Omega_b varied_rates.Omega_d]; field; lra.
  Qed.

  Lemma near_one (f : R -> R) d : is_derive f 0 d -> exists delta, 0 < delta /\ forall e, Rabs e < delta ->
    Rabs (f e - f 0) <= 1.
  Proof.
    intros D; destruct (remainder f d D 1) as (delta & P & Q); [lra|]; pose proof (Rabs_pos d).
    exists (Rmin delta (1 / (Rabs d + 1))); split; [apply Rmin_pos; [exact P | apply Rdiv_lt_0_compat; lra]|].
    intros e E; pose proof (Rlt_le_trans _ _ _ E (Rmin_l _ _)) as A;
      pose proof (Rlt_le_trans _ _ _ E (Rmin_r _ _)) as B.
    specialize (Q e A); replace (f e - f 0) with ((f e - f 0 - e * d) + e * d) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; rewrite (Rabs_mult e d).
    assert (Rabs e * (Rabs d + 1) <= 1 / (Rabs d + 1) * (Rabs d + 1)) by (apply Rmult_le_compat_r; lra).
    replace (1 / (Rabs d + 1) * (Rabs d + 1)) with 1 in * by (field; lra); lra.
  Qed.

  Lemma near_positive c dc : 0 < c -> exists delta, 0 < delta /\ forall e, Rabs e < delta -> 0 < c + e * dc.
  Proof.
    intros P; pose proof (Rabs_pos dc); exists (c / (Rabs dc + 1)); split; [apply Rdiv_lt_0_compat; lra|].
    intros e E; assert (Rabs e * (Rabs dc + 1) < c).
    { replace c with (c / (Rabs dc + 1) * (Rabs dc + 1)) by (field; lra); apply Rmult_lt_compat_r; lra. }
    pose proof (Rabs_mult e dc); pose proof (Rabs_pos e); pose proof (Rle_abs (- (e * dc)));
      rewrite Rabs_Ropp in *; nra.
  Qed.

  Theorem derivatives_of_rates t : is_derive (fun e => u_a e t) 0 (y_a t) /\
    is_derive (fun e => u_b e t) 0 (y_b t) /\
    is_derive (fun e => u_d e t) 0 (y_d t).
  Proof.
    destruct alphas_derive as (Aa & Ab & Ad), at_start as (_ & Ya & Yb & Yd).
    set (f e := bound (c_a + e * dc_a) (c_b + e * dc_b) (c_d + e * dc_d) (v_a + e * dv_a) (v_b + e * dv_b)
      (v_d + e * dv_d)).
    assert (F : ex_derive f 0).
    { unfold f, bound; auto_derive; repeat split; rewrite Rmult_0_l, Rplus_0_r; lra. }
    destruct F as (df & F), (near_one f df F) as (r & Rp & N), (near_positive c_a dc_a Ca) as (ra & Pa & Na),
      (near_positive c_b dc_b Cb) as (rb & Pb & Nb), (near_positive c_d dc_d Cd) as (rd & Pd & Nd).
    set (near := Rmin (Rmin reach r) (Rmin ra (Rmin rb rd))).
    assert (Near : 0 < near) by (unfold near; repeat apply Rmin_pos; assumption).
    assert (Q : forall e, Rabs e < near -> Rabs e < reach /\ Rabs e < r /\ Rabs e < ra /\ Rabs e < rb /\
      Rabs e < rd).
    { intros e E; unfold near in E; repeat split; eapply Rlt_le_trans; try exact E.
      - eapply Rle_trans; apply Rmin_l.
      - eapply Rle_trans; [apply Rmin_l | apply Rmin_r].
      - eapply Rle_trans; [apply Rmin_r | apply Rmin_l].
      - eapply Rle_trans; [apply Rmin_r | eapply Rle_trans; [apply Rmin_r | apply Rmin_l]].
      - eapply Rle_trans; [apply Rmin_r | eapply Rle_trans; [apply Rmin_r | apply Rmin_r]]. }
    assert (W : forall e t, Rabs e < near -> is_derive (u_a e) t (alpha_a e * u_b e t * u_d e t) /\
      is_derive (u_b e) t (alpha_b e * u_d e t * u_a e t) /\ is_derive (u_d e) t (alpha_d e * u_a e t
        * u_b e t)).
    { intros e x E; destruct (Q e E) as (E1 & _); exact (family_rates _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ U e
      E1 x). }
    assert (Bd : forall e t, Rabs e < near -> Rabs (u_a e t) <= f 0 + 1 /\ Rabs (u_b e t) <= f 0 + 1 /\
      Rabs (u_d e t) <= f 0 + 1).
    { intros e x E; destruct (Q e E) as (E1 & E2 & E3 & E4 & E5).
      pose proof (rates_bounded _ _ _ _ (Na e E3) (Nb e E4) (Nd e E5)
        _ _ _ x (family_rates _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ U e E1)) as P.
      cbv zeta in P; destruct (family_start _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ U e E1) as (Sa & Sb & Sd);
        rewrite Sa, Sb, Sd in P.
      fold (f e) in P; specialize (N e E2); apply Rabs_le_between in N; lra. }
    assert (St : forall e, Rabs e < near -> u_a e 0 = u_a 0 0 + e * y_a 0 /\ u_b e 0 = u_b 0 0 + e * y_b 0 /\
      u_d e 0 = u_d 0 0 + e * y_d 0).
    { intros e E; destruct (Q e E) as (E1 & _); destruct (family_start _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ U e
      E1) as (Sa & Sb & Sd).
      destruct (family_start _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ U 0 ltac:(now rewrite Rabs_R0))
        as (Ta & Tb & Td).
      rewrite Sa, Sb, Sd, Ta, Tb, Td, Ya, Yb, Yd; repeat split; ring. }
    assert (A0 : alpha_a 0 = varied_rates.alpha_a X /\ alpha_b 0 = varied_rates.alpha_b X /\
      alpha_d 0 = varied_rates.alpha_d X).
    { unfold alpha_a, alpha_b, alpha_d; cbn; unfold coefficients.alpha_a, coefficients.alpha_b,
      coefficients.alpha_d,
        coefficients.c_ab, coefficients.c_ad, coefficients.c_bd; cbn; rewrite !Rmult_0_l, !Rplus_0_r;
          repeat split; field; lra. }
    destruct A0 as (A0a & A0b & A0d).
    assert (Y : forall t, is_derive y_a t (d_a * u_b 0 t * u_d 0 t + alpha_a 0 * (y_b t * u_d 0 t
      + u_b 0 t * y_d t)) /\
      is_derive y_b t (d_b * u_d 0 t * u_a 0 t + alpha_b 0 * (y_d t * u_a 0 t + u_d 0 t * y_a t)) /\
      is_derive y_d t (d_d * u_a 0 t * u_b 0 t + alpha_d 0 * (y_a t * u_b 0 t + u_a 0 t * y_b t))).
    { intros x; destruct (middle_member x) as (-> & -> & ->); rewrite A0a, A0b, A0d.
      destruct (varied_rates.fact_by_Omega_a X H x) as (aa & ba & da),
        (varied_rates.fact_by_Omega_b X H x) as (ab & bb & db),
        (varied_rates.fact_by_Omega_d X H x) as (ad & bd & dd),
          (varied_rates.fact_by_c_a X H x) as (ac & bc & dc),
        (varied_rates.fact_by_c_b X H x) as (ac' & bc' & dc'),
          (varied_rates.fact_by_c_d X H x) as (ac'' & bc'' & dc'').
      split; [|split].
      - refine (derive_as _ _ _ _ (derive_combination _ _ _ _ _ _ x _ _ _ _ _ _ dv_a dv_b dv_d dc_a dc_b dc_d
        aa ab ad ac ac' ac'') _).
        unfold y_a, y_b, y_d, column_a, column_b, column_d, d_a.
        change (coefficients.alpha_a_by_c_a C) with (varied_rates.alpha_a_by_c_a X).
        change (coefficients.alpha_a_by_c_b C) with (varied_rates.alpha_a_by_c_b X).
        change (coefficients.alpha_a_by_c_d C) with (varied_rates.alpha_a_by_c_d X); ring.
      - refine (derive_as _ _ _ _ (derive_combination _ _ _ _ _ _ x _ _ _ _ _ _ dv_a dv_b dv_d dc_a dc_b dc_d
        ba bb bd bc bc' bc'') _).
        unfold y_a, y_b, y_d, column_a, column_b, column_d, d_b.
        change (coefficients.alpha_b_by_c_a C) with (varied_rates.alpha_b_by_c_a X).
        change (coefficients.alpha_b_by_c_b C) with (varied_rates.alpha_b_by_c_b X).
        change (coefficients.alpha_b_by_c_d C) with (varied_rates.alpha_b_by_c_d X); ring.
      - refine (derive_as _ _ _ _ (derive_combination _ _ _ _ _ _ x _ _ _ _ _ _ dv_a dv_b dv_d dc_a dc_b dc_d
        da db dd dc dc' dc'') _).
        unfold y_a, y_b, y_d, column_a, column_b, column_d, d_d.
        change (coefficients.alpha_d_by_c_a C) with (varied_rates.alpha_d_by_c_a X).
        change (coefficients.alpha_d_by_c_b C) with (varied_rates.alpha_d_by_c_b X).
        change (coefficients.alpha_d_by_c_d C) with (varied_rates.alpha_d_by_c_d X); ring.
    }
    assert (O : forall e, Rabs e < near -> Rabs e < near) by trivial; split; [|split].
    - apply (derivative_of_a alpha_a alpha_b alpha_d d_a d_b d_d u_a u_b u_d y_a y_b y_d (f 0 + 1)
      near Aa Ab Ad Near);
        try (intros e x E; apply (W e x E)); try (intros x; apply (Y x)); [exact Bd | exact St].
    - apply (derivative_of_a alpha_b alpha_d alpha_a d_b d_d d_a u_b u_d u_a y_b y_d y_a (f 0 + 1)
      near Ab Ad Aa Near);
        try (intros e x E; apply (W e x E)); try (intros x; apply (Y x)); intros e;
        [intros x E; destruct (Bd e x E) as (? & ? & ?) | intros E; destruct (St e E) as (? & ? & ?)]; auto.
    - apply (derivative_of_a alpha_d alpha_a alpha_b d_d d_a d_b u_d u_a u_b y_d y_a y_b (f 0 + 1)
      near Ad Aa Ab Near);
        try (intros e x E; apply (W e x E)); try (intros x; apply (Y x)); intros e;
        [intros x E; destruct (Bd e x E) as (? & ? & ?) | intros E; destruct (St e E) as (? & ? & ?)]; auto.
  Qed.
End Columns.
