(* The torque of a kick: what the context `kick` of the ledger proves, in plain words.

   A vector u that stays in space is v = conj(q) u q in body axes.  A potential U is linear and
   quadratic in v, with a symmetric matrix Q.  The torque T of this potential is the negative of its
   gradient by turns of the body: every motion of the body loses U by the power of T, and no other
   vector has this property.  Vectors are quaternions whose first part is zero. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Rigidsym.theorems Require Import motion steady.
From Rigidsym.contexts Require kick.
Open Scope R_scope.

Definition vector (x1 x2 x3 : R) : quaternion := Quaternion 0 x1 x2 x3.
Definition dot (x y : quaternion) : R := part_a x * part_a y + part_b x * part_b y + part_d x * part_d y.
Definition in_body (u q : quaternion) : quaternion := product 1 (product 1 (conjugate q) u) q.

Section Kick.
  Variables (u b m : quaternion) (k Q11 Q22 Q33 Q23 Q13 Q12 : R).
  Hypothesis (U_vector : part_0 u = 0).

  Let times_Q (v : quaternion) : quaternion := vector
    (Q11 * part_a v + Q12 * part_b v + Q13 * part_d v)
    (Q12 * part_a v + Q22 * part_b v + Q23 * part_d v)
    (Q13 * part_a v + Q23 * part_b v + Q33 * part_d v).
  Let potential (q : quaternion) : R :=
    let v := in_body u q in dot v (times_Q v) / 2 - dot m v.

  (* The names of the ledger, for a motion of the body with rates w. *)
  Let names (w1 w2 w3 : R -> R) (q : R -> quaternion) : kick.names := kick.name
    (fun t => part_0 (q t)) (fun t => part_a (q t)) (fun t => part_b (q t)) (fun t => part_d (q t))
    w1 w2 w3 (part_a u) (part_b u) (part_d u) (part_a b) (part_b b) (part_d b) k
    (part_a m) (part_b m) (part_d m) Q11 Q22 Q33 Q23 Q13 Q12.

  (* The published torque at an attitude: b, k v, and the torque of the potential. *)
  Let published (p : quaternion) : quaternion :=
    let X := names (fun _ => 0) (fun _ => 0) (fun _ => 0) (fun _ => p) in
    vector (kick.T1 X 0) (kick.T2 X 0) (kick.T3 X 0).
  Let torque (p : quaternion) : quaternion :=
    let v := in_body u p in
    vector (part_a (published p) - part_a b - k * part_a v)
      (part_b (published p) - part_b b - k * part_b v)
      (part_d (published p) - part_d b - k * part_d v).

  Lemma direction_in_ledger w1 w2 w3 q t : norm_squared (q t) = 1 -> let X := names w1 w2 w3 q in
    in_body u (q t) = vector (kick.v1 X t) (kick.v2 X t) (kick.v3 X t).
  Proof.
    unfold in_body, kick.v1, kick.v2, kick.v3, kick.w1, kick.w2, kick.w3, vector, norm_squared; cbn -[pow].
    destruct (q t) as [p_0 p_a p_b p_d], u as [u_0 u_a u_b u_d]; cbn -[pow] in *; subst u_0; intros N.
    assert (P : p_0 ^ 2 = 1 - p_a ^ 2 - p_b ^ 2 - p_d ^ 2) by lra.
    unfold product, conjugate; cbn -[pow]; f_equal; ring [P].
  Qed.

  Lemma power_of_torque w1 w2 w3 q : kinematics 1 w1 w2 w3 q -> norm_squared (q 0) = 1 -> forall t,
    is_derive (fun s => potential (q s)) t (- dot (vector (w1 t) (w2 t) (w3 t)) (torque (q t))).
  Proof.
    intros D N t; set (X := names w1 w2 w3 q).
    assert (Unit : forall s, norm_squared (q s) = 1)
      by (intros s; rewrite (norm_kept 1 w1 w2 w3 q D s); exact N).
    pose proof (fun s => direction_in_ledger w1 w2 w3 q s (Unit s)) as V; fold X in V.
    assert (H : kick.holds X).
    { constructor; intros s; [specialize (Unit s); unfold norm_squared in Unit; cbn -[pow]; lra | ..];
        destruct (D s) as (D0 & Da & Db & Dd);
        [refine (derive_as _ _ _ _ D0 _) | refine (derive_as _ _ _ _ Da _)
        | refine (derive_as _ _ _ _ Db _) | refine (derive_as _ _ _ _ Dd _)]; cbn; field. }
    refine (derive_as _ _ _ _ (is_derive_ext _ _ t _ _ (kick.fact_work X H t)) _).
    - intros s; unfold potential; rewrite V; unfold kick.U, kick.g1, kick.g2, kick.g3, dot, times_Q.
      cbn -[kick.v1 kick.v2 kick.v3]; field.
    - unfold torque; rewrite V; unfold dot; cbn -[kick.T1 kick.T2 kick.T3 kick.v1 kick.v2 kick.v3].
      match goal with |- context [kick.T1 ?rest 0] => change (kick.T1 rest 0) with (kick.T1 X t);
        change (kick.T2 rest 0) with (kick.T2 X t); change (kick.T3 rest 0) with (kick.T3 X t) end; ring.
  Qed.

  (* At each attitude, the torque is the only vector with this property. *)
  Theorem kick_torque p : norm_squared p = 1 -> forall x : quaternion, part_0 x = 0 ->
    (x = torque p <-> forall w1 w2 w3 q, kinematics 1 w1 w2 w3 q -> q 0 = p ->
      is_derive (fun t => potential (q t)) 0 (- dot (vector (w1 0) (w2 0) (w3 0)) x)).
  Proof.
    intros N x Z; split.
    - intros -> w1 w2 w3 q D S; rewrite <- S; apply power_of_torque; [exact D | now rewrite S].
    - intros P.
      assert (along : forall v1 v2 v3, 0 < v1 ^ 2 + v2 ^ 2 + v3 ^ 2 ->
        dot (vector v1 v2 v3) x = dot (vector v1 v2 v3) (torque p)).
      { intros v1 v2 v3 V.
        assert (M : exists q, kinematics 1 (fun _ => v1) (fun _ => v2) (fun _ => v3) q /\ q 0 = p).
        { destruct (steady_motion 1 1 1 1 v1 v2 v3 p) as (M & _); try lra.
          destruct M as [_ D _ _ _ S]; eexists; split; [exact D | exact S]. }
        destruct M as (q & D & S); specialize (P _ _ _ q D S).
        pose proof (power_of_torque _ _ _ q D ltac:(now rewrite S) 0) as T; rewrite S in T.
        pose proof (is_derive_unique _ _ _ P); pose proof (is_derive_unique _ _ _ T); lra. }
      pose proof (along 1 0 0 ltac:(lra)) as A; pose proof (along 0 1 0 ltac:(lra)) as B;
        pose proof (along 0 0 1 ltac:(lra)) as C.
      destruct x as [x_0 x_a x_b x_d]; cbn in Z; subst x_0.
      unfold dot, vector in A, B, C; cbn -[torque] in A, B, C.
      change (torque p) with (vector (part_a (torque p)) (part_b (torque p)) (part_d (torque p))).
      unfold vector; f_equal; lra.
  Qed.
End Kick.
