(* Steady motion: rates that do not change, because momentum and rates are parallel; and rest. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Rigidsym.theorems Require Import motion.
Open Scope R_scope.

Lemma derive_constant (x t : R) : is_derive (fun _ => x) t 0.
Proof. apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule)). Qed.

Section Steady.
  Variables (h c_a c_b c_d v_a v_b v_d : R) (p : quaternion).
  Hypotheses (H : h ^ 2 = 1) (Ca : 0 < c_a) (Cb : 0 < c_b) (Cd : 0 < c_d).
  (* Momentum and rates are parallel. *)
  Hypotheses (parallel_a : (c_b - c_d) * v_b * v_d = 0) (parallel_b : (c_d - c_a) * v_d * v_a = 0)
    (parallel_d : (c_a - c_b) * v_a * v_b = 0).

  Lemma steady_rates : euler h c_a c_b c_d (fun _ => v_a) (fun _ => v_b) (fun _ => v_d).
  Proof.
    intros t; split; [|split]; refine (derive_as _ _ _ _ (derive_constant _ t) _).
    - transitivity (h * ((c_b - c_d) * v_b * v_d) / c_a); [rewrite parallel_a|]; field; lra.
    - transitivity (h * ((c_d - c_a) * v_d * v_a) / c_b); [rewrite parallel_b|]; field; lra.
    - transitivity (h * ((c_a - c_b) * v_a * v_b) / c_d); [rewrite parallel_d|]; field; lra.
  Qed.

  Theorem steady_motion : 0 < v_a ^ 2 + v_b ^ 2 + v_d ^ 2 ->
    let w := sqrt (v_a ^ 2 + v_b ^ 2 + v_d ^ 2) in
    let turn t := Quaternion (cos (w * t / 2)) (v_a / w * sin (w * t / 2)) (v_b / w * sin (w * t / 2))
      (v_d / w * sin (w * t / 2)) in
    the_motion h c_a c_b c_d v_a v_b v_d p (fun _ => v_a) (fun _ => v_b) (fun _ => v_d)
      (fun t => product h p (turn t)).
  Proof.
    intros V w turn; pose proof (sqrt_lt_R0 _ V : 0 < w) as W.
    pose proof (pow2_sqrt _ (Rlt_le _ _ V) : w ^ 2 = _) as S.
    assert (N : (v_d / w) ^ 2 = 1 - (v_a / w) ^ 2 - (v_b / w) ^ 2).
    { transitivity (v_d ^ 2 / w ^ 2); [field; lra|].
      replace (v_d ^ 2) with (w ^ 2 - v_a ^ 2 - v_b ^ 2) by lra; field; lra. }
    assert (steady : kinematics h (fun _ => v_a) (fun _ => v_b) (fun _ => v_d)
      (fun t => product h p (turn t))).
    { intros t; replace v_a with (w * (v_a / w)) by (field; lra);
        replace v_b with (w * (v_b / w)) by (field; lra);
        replace v_d with (w * (v_d / w)) by (field; lra); unfold turn.
      set (x := v_a / w) in *; set (y := v_b / w) in *; set (z := v_d / w) in *; clearbody w x y z.
      destruct p as [p_0 p_a p_b p_d]; cbn -[pow]; refine (conj _ (conj _ (conj _ _)));
        auto_derive; trivial; change (w * t * / 2) with (w * t / 2); field [H N]. }
    apply unique; trivial; constructor; trivial; [apply steady_rates |].
    unfold turn; replace (w * 0 / 2) with 0 by field; rewrite cos_0, sin_0.
    destruct p; unfold product; cbn; f_equal; ring.
  Qed.

  Theorem rest : v_a = 0 -> v_b = 0 -> v_d = 0 ->
    the_motion h c_a c_b c_d v_a v_b v_d p (fun _ => v_a) (fun _ => v_b) (fun _ => v_d) (fun _ => p).
  Proof.
    intros Va Vb Vd; apply unique; trivial; constructor; trivial; [apply steady_rates|].
    intros t; cbn; rewrite Va, Vb, Vd; refine (conj _ (conj _ (conj _ _)));
      refine (derive_as _ _ _ _ (derive_constant _ t) _); field.
  Qed.
End Steady.
