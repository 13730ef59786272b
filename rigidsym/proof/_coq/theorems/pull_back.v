(* The attitude from the rates and one angle: what the context `attitude` of the ledger proves.

   K is the length of the momentum M in body axes, and s = 1 or -1 chooses a side of axis a, on which M
   never is opposite to it.  The attitude that is pulled back to axis a is the shortest turn from M to
   s e_a, then a turn by the angle psi about s e_a. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Rigidsym.theorems Require Import motion.
From Rigidsym.contexts Require attitude.
Open Scope R_scope.

Definition shortest (h s K M_a M_b M_d : R) : quaternion :=
  let nu := sqrt (2 * K * (K + s * M_a)) in
  Quaternion (nu / (2 * K)) 0 (s * h * M_d / nu) (- s * h * M_b / nu).

Definition about_a (s psi : R) : quaternion := Quaternion (cos (psi / 2)) (s * sin (psi / 2)) 0 0.

Definition pulled_back (h s K M_a M_b M_d psi : R) : quaternion :=
  product h (about_a s psi) (shortest h s K M_a M_b M_d).

(* Attitudes r as they are from the start p on. *)
Definition from_start (h : R) (p : quaternion) (r : R -> quaternion) (t : R) : quaternion :=
  product h (product h p (conjugate (r 0))) (r t).

Definition energy (c_a c_b c_d w_a w_b w_d : R) : R :=
  (c_a * w_a ^ 2 + c_b * w_b ^ 2 + c_d * w_d ^ 2) / 2.

Lemma norm_of_product h p q : h ^ 2 = 1 ->
  norm_squared (product h p q) = norm_squared p * norm_squared q.
Proof. intros H; unfold norm_squared, product; cbn [part_0 part_a part_b part_d]; ring [H]. Qed.

Lemma norm_of_conjugate q : norm_squared (conjugate q) = norm_squared q.
Proof. unfold norm_squared, conjugate; cbn [part_0 part_a part_b part_d]; ring. Qed.

Lemma from_start_at_start h p r : h ^ 2 = 1 -> norm_squared (r 0) = 1 -> from_start h p r 0 = p.
Proof.
  intros H N; unfold from_start; destruct p as [p_0 p_a p_b p_d], (r 0) as [r_0 r_a r_b r_d].
  unfold product, conjugate, norm_squared in *; cbn [part_0 part_a part_b part_d] in *.
  assert (N' : r_0 ^ 2 = 1 - r_a ^ 2 - r_b ^ 2 - r_d ^ 2) by lra.
  f_equal; ring [H N'].
Qed.

Section PulledBack.
  Variables (h s c_a c_b c_d v_a v_b v_d : R) (p : quaternion) (w_a w_b w_d psi : R -> R).
  Hypotheses (H : h ^ 2 = 1) (S : s ^ 2 = 1) (Ca : 0 < c_a) (Cb : 0 < c_b) (Cd : 0 < c_d).
  Hypotheses (E : euler h c_a c_b c_d w_a w_b w_d) (P : norm_squared p = 1).
  Hypotheses (Va : w_a 0 = v_a) (Vb : w_b 0 = v_b) (Vd : w_d 0 = v_d).
  Let K := sqrt ((c_a * v_a) ^ 2 + (c_b * v_b) ^ 2 + (c_d * v_d) ^ 2).
  Hypotheses (K_positive : 0 < K) (side : forall t, 0 < K + s * (c_a * w_a t)).
  Hypothesis turns : forall t, is_derive psi t
    ((2 * energy c_a c_b c_d v_a v_b v_d + K * s * w_a t) / (K + s * (c_a * w_a t))).

  Let nu t := sqrt (2 * K * (K + s * (c_a * w_a t))).
  Let r t := pulled_back h s K (c_a * w_a t) (c_b * w_b t) (c_d * w_d t) (psi t).

  Lemma under_root t : 0 < 2 * K * (K + s * (c_a * w_a t)).
  Proof. apply Rmult_lt_0_compat; [lra | apply side]. Qed.

  Let names (p : quaternion) : attitude.names := attitude.name h s c_a c_b c_d w_a w_b w_d K nu
    (fun t => cos (psi t / 2)) (fun t => sin (psi t / 2)) (part_0 p) (part_a p) (part_b p) (part_d p).

  Lemma as_in_ledger p' : norm_squared p' = 1 -> attitude.holds (names p').
  Proof.
    intros N.
    assert (K2 : forall t, K ^ 2 = (c_a * w_a t) ^ 2 + (c_b * w_b t) ^ 2 + (c_d * w_d t) ^ 2).
    { intros t; rewrite (momentum_kept h c_a c_b c_d Ca Cb Cd w_a w_b w_d E t), Va, Vb, Vd.
      apply pow2_sqrt; pose proof (pow2_ge_0 (c_a * v_a)); pose proof (pow2_ge_0 (c_b * v_b));
        pose proof (pow2_ge_0 (c_d * v_d)); lra. }
    assert (Nu : forall t, nu t ^ 2 = 2 * K * (K + s * (c_a * w_a t)))
      by (intros; apply pow2_sqrt; left; apply under_root).
    pose proof (fun t => sqrt_lt_R0 _ (under_root t) : 0 < nu t) as Np.
    constructor; unfold attitude.psi_rate, attitude.H_, attitude.M_a, attitude.M_b, attitude.M_d;
      cbn -[pow]; try (intros t; pose proof (side t); pose proof (Np t)); try lra.
    - rewrite (K2 t); ring.
    - rewrite Nu; ring.
    - pose proof (sin2_cos2 (psi t / 2)); unfold Rsqr in *; lra.
    - unfold norm_squared in N; lra.
    - match goal with |- is_derive _ _ ?rate => replace rate with (h * (c_b - c_d) / c_a * w_b t * w_d t) by (field; lra) end.
      apply E.
    - match goal with |- is_derive _ _ ?rate => replace rate with (h * (c_d - c_a) / c_b * w_d t * w_a t) by (field; lra) end.
      apply E.
    - match goal with |- is_derive _ _ ?rate => replace rate with (h * (c_a - c_b) / c_d * w_a t * w_b t) by (field; lra) end.
      apply E.
    - destruct (E t) as (Da & _ & _); unfold nu; derive_known; [apply under_root |].
      fold (nu t); field; lra.
    - rewrite (energy_kept h c_a c_b c_d Ca Cb Cd w_a w_b w_d E t), Va, Vb, Vd.
      pose proof (turns t); derive_known; change (psi t * / 2) with (psi t / 2); unfold energy; field; lra.
    - rewrite (energy_kept h c_a c_b c_d Ca Cb Cd w_a w_b w_d E t), Va, Vb, Vd.
      pose proof (turns t); derive_known; change (psi t * / 2) with (psi t / 2); unfold energy; field; lra.
  Qed.

  (* What the ledger calls qbar and q. *)
  Lemma r_in_ledger t : let X := names p in
    r t = Quaternion (attitude.qbar_0 X t) (attitude.qbar_a X t) (attitude.qbar_b X t) (attitude.qbar_d X t).
  Proof.
    unfold r, pulled_back, product, shortest, about_a; fold (nu t); cbn -[pow].
    unfold attitude.qbar_0, attitude.qbar_a, attitude.qbar_b, attitude.qbar_d,
      attitude.s_0, attitude.s_b, attitude.s_d, attitude.M_a, attitude.M_b, attitude.M_d.
    cbn -[pow]; f_equal; unfold Rdiv; ring.
  Qed.

  Let p' := product h p (conjugate (r 0)).
  Lemma q_in_ledger t : let X := names p' in
    from_start h p r t = Quaternion (attitude.q_0 X t) (attitude.q_a X t) (attitude.q_b X t) (attitude.q_d X t).
  Proof.
    unfold from_start; fold p'; rewrite r_in_ledger; unfold product; cbn [part_0 part_a part_b part_d].
    unfold attitude.q_0, attitude.q_a, attitude.q_b, attitude.q_d; f_equal; ring.
  Qed.

  Lemma norm_of_r t : norm_squared (r t) = 1.
  Proof. rewrite r_in_ledger; exact (proj1 (attitude.fact_particular _ (as_in_ledger p P) t)). Qed.

  Theorem pulled_back_motion :
    the_motion h c_a c_b c_d v_a v_b v_d p w_a w_b w_d (from_start h p r).
  Proof.
    apply unique; trivial; constructor; trivial; [|now apply from_start_at_start, norm_of_r].
    assert (P' : norm_squared p' = 1)
      by (unfold p'; rewrite norm_of_product, norm_of_conjugate, P, norm_of_r by trivial; ring).
    intros t; destruct (attitude.fact_solution _ (as_in_ledger p' P') t) as (_ & D0 & Da & Db & Dd).
    refine (conj _ (conj _ (conj _ _)));
      [refine (derive_as _ t _ _ (is_derive_ext _ _ t _ _ D0) _)
      |refine (derive_as _ t _ _ (is_derive_ext _ _ t _ _ Da) _)
      |refine (derive_as _ t _ _ (is_derive_ext _ _ t _ _ Db) _)
      |refine (derive_as _ t _ _ (is_derive_ext _ _ t _ _ Dd) _)];
      intros; rewrite q_in_ledger; cbn [product part_0 part_a part_b part_d]; try reflexivity;
      unfold Rdiv; cbn -[attitude.q_0 attitude.q_a attitude.q_b attitude.q_d]; ring.
  Qed.
End PulledBack.

(* The angle as an integral. *)
Lemma derive_integral (f : R -> R) : (forall t, ex_derive f t) ->
  forall t, is_derive (RInt f 0) t (f t).
Proof.
  intros D t.
  assert (C : forall x, continuous f x)
    by (intros; now apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule))).
  apply (is_derive_RInt f (RInt f 0) 0 t); [|apply C].
  apply filter_forall; intros x; apply (RInt_correct (V := R_CompleteNormedModule)).
  apply (ex_RInt_continuous (V := R_CompleteNormedModule)); intros; apply C.
Qed.
