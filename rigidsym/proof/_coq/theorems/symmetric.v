(* The motion of a body with two equal moments that turns about its axis, not only across it. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Rigidsym.theorems Require Import motion pull_back.
Open Scope R_scope.

Theorem symmetric_motion (h sigma c_a c v_a v_b v_d : R) (p : quaternion) :
  h ^ 2 = 1 -> 0 < c_a -> 0 < c -> norm_squared p = 1 ->
  (* sigma is the side of v_a. *)
  sigma ^ 2 = 1 -> 0 < sigma * v_a ->
  let n := h * (1 - c_a / c) * v_a in
  let w_b t := v_b * cos (n * t) + v_d * sin (n * t) in
  let w_d t := v_d * cos (n * t) - v_b * sin (n * t) in
  let K := sqrt ((c_a * v_a) ^ 2 + (c * v_b) ^ 2 + (c * v_d) ^ 2) in
  let psi t := (K / c + (1 - c_a / c) * (sigma * v_a)) * t in
  the_motion h c_a c c v_a v_b v_d p (fun _ => v_a) w_b w_d (from_start h p (fun t =>
    pulled_back h sigma K (c_a * v_a) (c * w_b t) (c * w_d t) (psi t))).
Proof.
  intros H Ca Cb P Sigma Sa n w_b w_d K psi.
  assert (Ma : 0 < c_a * (sigma * v_a)) by now apply Rmult_lt_0_compat.
  assert (M2 : 0 < (c_a * v_a) ^ 2 + (c * v_b) ^ 2 + (c * v_d) ^ 2).
  { pose proof (pow2_ge_0 (c * v_b)); pose proof (pow2_ge_0 (c * v_d)).
    pose proof (pow_lt _ 2 Ma) as M.
    replace ((c_a * (sigma * v_a)) ^ 2) with ((c_a * v_a) ^ 2) in M by ring [Sigma]; lra. }
  pose proof (sqrt_lt_R0 _ M2 : 0 < K) as Kp; pose proof (pow2_sqrt _ (Rlt_le _ _ M2) : K ^ 2 = _) as K2.
  assert (N : 0 < K + sigma * (c_a * v_a)) by lra.
  apply pulled_back_motion; trivial.
  - intros t; split; [|split]; unfold w_b, w_d.
    + refine (derive_as _ _ _ _ (is_derive_const (K := R_AbsRing) (V := R_NormedModule) v_a t) _).
      unfold zero; cbn; field; lra.
    + auto_derive; trivial; unfold n; field; lra.
    + auto_derive; trivial; unfold n; field; lra.
  - unfold w_b; rewrite Rmult_0_r, cos_0, sin_0; ring.
  - unfold w_d; rewrite Rmult_0_r, cos_0, sin_0; ring.
  - intros t; fold K; unfold psi, energy; auto_derive; trivial.
    apply (Rmult_eq_reg_r (c * (K + sigma * (c_a * v_a)))); [|apply Rgt_not_eq, Rmult_lt_0_compat; lra].
    transitivity (K ^ 2 + (c - c_a) * (sigma * v_a) * K + K * (sigma * (c_a * v_a))
      + (c - c_a) * c_a * (sigma ^ 2 * v_a ^ 2)); [field; lra | rewrite K2, Sigma; field; lra].
Qed.
