(* What every exported context uses: the language of the ledger over the reals, and a checker of its
   certificates with the proof that what it accepts is true.

   A text of the ledger is an `expr`; `value a e t` is what it says, where `a t` lists the values at
   time t of all names of a context.  `theory` is what is known of these names in the arithmetic of
   the kernel: every name and every inverse as a polynomial over a product of units.  A theory is
   built by steps, each of which is checked by computation and sound (`run_sound`); and claims that
   `check` accepts in a sound theory hold (`decided`).  Nothing here is specific to rigid bodies. *)
From Coq Require Export Reals Lra Lia List.
From Coq Require Import QArith Qreals Qreduction Ring_theory Ring_polynom BinList.
From Coquelicot Require Export Coquelicot.
Export ListNotations.
Open Scope R_scope.

(* * Expressions *)

Inductive expr : Set :=
  | Num (z : Z) | Var (k : positive) | Neg (x : expr)
  | Add (x y : expr) | Sub (x y : expr) | Mul (x y : expr) | Div (x y : expr)
  | Pow (x : expr) (n : nat) | Rate (x : expr).

Fixpoint value (a : R -> list R) (e : expr) (t : R) : R :=
  match e with
  | Num z => IZR z
  | Var k => BinList.nth 0 k (a t)
  | Neg x => - value a x t
  | Add x y => value a x t + value a y t
  | Sub x y => value a x t - value a y t
  | Mul x y => value a x t * value a y t
  | Div x y => value a x t / value a y t
  | Pow x n => value a x t ^ n
  | Rate x => Derive (fun s => value a x s) t
  end.

Definition same : forall x y : expr, {x = y} + {x <> y}.
Proof. decide equality; try apply Pos.eq_dec; try apply Z.eq_dec; apply Nat.eq_dec. Defined.

Section Lookup.
  Context {K V : Type} (equal : forall x y : K, {x = y} + {x <> y}).
  Fixpoint lookup (k : K) (table : list (K * V)) : option V :=
    match table with
    | nil => None
    | (j, v) :: rest => if equal k j then Some v else lookup k rest
    end.
  Lemma lookup_in k table v : lookup k table = Some v -> In (k, v) table.
  Proof.
    induction table as [|[j w] rest IH]; cbn; [discriminate|].
    destruct (equal k j) as [->|_]; [intros [= ->]; now left | right; auto].
  Qed.
End Lookup.

(* * Polynomials over Q: those of the tactic `ring`, with its proofs *)

Lemma Q_in_R : ring_morph 0 1 Rplus Rmult Rminus Ropp (@eq R)
  0%Q 1%Q Qplus' Qmult' Qminus' Qopp Qeq_bool Q2R.
Proof.
  constructor; intros.
  - unfold Q2R; cbn; field.
  - unfold Q2R; cbn; field.
  - unfold Qplus'; rewrite (Qeq_eqR _ _ (Qred_correct _)); apply Q2R_plus.
  - unfold Qminus'; rewrite (Qeq_eqR _ _ (Qred_correct _)); apply Q2R_minus.
  - unfold Qmult'; rewrite (Qeq_eqR _ _ (Qred_correct _)); apply Q2R_mult.
  - apply Q2R_opp.
  - now apply Qeq_eqR, Qeq_bool_eq.
Qed.
Lemma R_ext : ring_eq_ext Rplus Rmult Ropp (@eq R).
Proof. constructor; repeat intro; congruence. Qed.
Definition R_ring : almost_ring_theory 0 1 Rplus Rmult Rminus Ropp (@eq R) :=
  Rth_ARth (Eqsth R) R_ext RTheory.

Definition poly := Pol Q.
Definition padd : poly -> poly -> poly := Padd 0%Q Qplus' Qeq_bool.
Definition pmul : poly -> poly -> poly := Pmul 0%Q 1%Q Qplus' Qmult' Qeq_bool.
Definition popp : poly -> poly := Popp Qopp.
Definition var (k : positive) : poly := mk_X 0%Q 1%Q k.
Definition constant (q : Q) : poly := Pc q.
Definition at_ (l : list R) : poly -> R := Pphi 0 Rplus Rmult Q2R l.
Definition zero (p : poly) : bool := Peq Qeq_bool p (constant 0).

Lemma padd_at l p q : at_ l (padd p q) = at_ l p + at_ l q.
Proof. exact (Padd_ok (Eqsth R) R_ext R_ring Q_in_R q p l). Qed.
Lemma pmul_at l p q : at_ l (pmul p q) = at_ l p * at_ l q.
Proof. exact (Pmul_ok (Eqsth R) R_ext R_ring Q_in_R p q l). Qed.
Lemma popp_at l p : at_ l (popp p) = - at_ l p.
Proof. exact (Popp_ok (Eqsth R) R_ext R_ring Q_in_R p l). Qed.
Lemma var_at l k : at_ l (var k) = BinList.nth 0 k l.
Proof. symmetry; exact (mkX_ok (Eqsth R) R_ext R_ring Q_in_R k l). Qed.
Lemma zero_at l p : zero p = true -> at_ l p = 0.
Proof.
  intros Z; rewrite <- (morph0 Q_in_R).
  exact (Peq_ok (Eqsth R) R_ext Q_in_R p (constant 0) Z l).
Qed.

Fixpoint ppow (p : poly) (n : nat) : poly :=
  match n with O => constant 1 | S O => p | S m => pmul p (ppow p m) end.
Lemma ppow_at l p n : at_ l (ppow p n) = at_ l p ^ n.
Proof.
  induction n as [|[|n] IH]; [exact (morph1 Q_in_R) | cbn; ring |].
  change (ppow p (S (S n))) with (pmul p (ppow p (S n))); rewrite pmul_at, IH; cbn; ring.
Qed.

(* A polynomial as it is written in files: coefficients with their monomials. *)
Definition term := (Q * list (positive * nat))%type.
Definition monomial (m : list (positive * nat)) : poly :=
  fold_right (fun xn p => pmul (ppow (var (fst xn)) (snd xn)) p) (constant 1) m.
Definition polynomial (ts : list term) : poly :=
  fold_right (fun qm p => padd (pmul (constant (fst qm)) (monomial (snd qm))) p) (constant 0) ts.

(* The sum of cofactors times what vanishes. *)
Fixpoint combination (cofactors : list (list term)) (relations : list poly) : poly :=
  match cofactors, relations with
  | nil :: cs, _ :: ps => combination cs ps
  | c :: cs, p :: ps => padd (pmul (polynomial c) p) (combination cs ps)
  | _, _ => constant 0
  end.
Lemma combination_at l relations : (forall p, In p relations -> at_ l p = 0) ->
  forall cofactors, at_ l (combination cofactors relations) = 0.
Proof.
  assert (Z : at_ l (constant 0) = 0) by exact (morph0 Q_in_R).
  induction relations as [|p ps IH]; intros H [|[|c cs] more]; cbn; try exact Z.
  - apply IH; auto with datatypes.
  - rewrite padd_at, pmul_at, IH, (H p) by auto with datatypes; ring.
Qed.

(* * Elements: a polynomial over a product of powers of units *)

Definition element := (poly * list nat)%type.

Fixpoint units_at (l : list R) (us : list poly) (ks : list nat) : R :=
  match us, ks with
  | u :: us, k :: ks => at_ l u ^ k * units_at l us ks
  | _, _ => 1
  end.
Fixpoint product (us : list poly) (ks : list nat) : poly :=
  match us, ks with
  | u :: us, O :: ks => product us ks
  | u :: us, k :: ks => pmul (ppow u k) (product us ks)
  | _, _ => constant 1
  end.
Fixpoint larger (a b : list nat) : list nat :=
  match a, b with x :: a, y :: b => max x y :: larger a b | nil, b => b | a, nil => a end.
Fixpoint sum (a b : list nat) : list nat :=
  match a, b with x :: a, y :: b => (x + y)%nat :: sum a b | nil, b => b | a, nil => a end.
Fixpoint less (a b : list nat) : list nat :=
  match a, b with x :: a, y :: b => (x - y)%nat :: less a b | nil, _ => nil | a, nil => a end.
Definition element_at (l : list R) (us : list poly) (e : element) : R :=
  at_ l (fst e) / units_at l us (snd e).

Lemma one_at l : at_ l (constant 1) = 1.
Proof. exact (morph1 Q_in_R). Qed.
Lemma product_at l us : forall ks, at_ l (product us ks) = units_at l us ks.
Proof.
  induction us as [|u us IH]; intros [|[|k] ks]; cbn [product units_at]; try apply one_at.
  - rewrite IH; cbn; ring.
  - rewrite pmul_at, ppow_at, IH; ring.
Qed.
Lemma sum_at l us : forall a b, units_at l us (sum a b) = units_at l us a * units_at l us b.
Proof.
  induction us as [|u us IH]; intros [|x a] [|y b]; cbn; try ring.
  rewrite IH, pow_add; ring.
Qed.
Lemma larger_left l us : forall a b,
  units_at l us (larger a b) = units_at l us (less (larger a b) a) * units_at l us a.
Proof.
  induction us as [|u us IH]; intros [|x a] [|y b]; cbn; try ring.
  - rewrite Nat.sub_diag; cbn. enough (units_at l us (less a a) = 1) as -> by ring.
    clear; revert us; induction a; intros [|u us]; cbn; try easy; rewrite Nat.sub_diag, IHa; cbn; ring.
  - rewrite IH. replace (Nat.max x y) with ((Nat.max x y - x) + x)%nat at 1 by lia.
    rewrite pow_add; ring.
Qed.
Lemma larger_comm : forall a b, larger a b = larger b a.
Proof. induction a as [|x a IH]; intros [|y b]; cbn; try easy. now rewrite Nat.max_comm, IH. Qed.

Section Elements.
  Variables (l : list R) (us : list poly).
  Hypothesis nonzero : forall u, In u us -> at_ l u <> 0.

  Lemma units_nonzero ks : units_at l us ks <> 0.
  Proof.
    revert ks; induction us as [|u rest IH]; intros [|k ks]; cbn; try apply R1_neq_R0.
    apply Rmult_integral_contrapositive_currified; auto using pow_nonzero with datatypes.
  Qed.

  Definition eadd (x y : element) : element :=
    let k := larger (snd x) (snd y) in
    (padd (pmul (fst x) (product us (less k (snd x)))) (pmul (fst y) (product us (less k (snd y)))), k).
  Definition emul (x y : element) : element := (pmul (fst x) (fst y), sum (snd x) (snd y)).
  Definition eneg (x : element) : element := (popp (fst x), snd x).
  Definition esub (x y : element) : element := eadd x (eneg y).
  Definition enum (q : Q) : element := (constant q, nil).
  Fixpoint epow (x : element) (n : nat) : element :=
    match n with O => enum 1 | S O => x | S m => emul x (epow x m) end.

  Notation "[ x ]" := (element_at l us x).
  Lemma eadd_at x y : [eadd x y] = [x] + [y].
  Proof.
    destruct x as [p a], y as [q b]; unfold element_at, eadd; cbn [fst snd].
    rewrite padd_at, !pmul_at, !product_at.
    pose proof (units_nonzero a); pose proof (units_nonzero b).
    pose proof (larger_left l us a b) as A; pose proof (larger_left l us b a) as B.
    rewrite (larger_comm b a) in B. pose proof (units_nonzero (larger a b)).
    set (k := larger a b) in *.
    apply (Rmult_eq_reg_r (units_at l us k)); [|assumption].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_plus_distr_r by assumption.
    f_equal; [rewrite A | rewrite B]; field; assumption.
  Qed.
  Lemma emul_at x y : [emul x y] = [x] * [y].
  Proof.
    unfold element_at, emul; cbn; rewrite pmul_at, sum_at; field; split; apply units_nonzero.
  Qed.
  Lemma eneg_at x : [eneg x] = - [x].
  Proof. unfold element_at, eneg; cbn; rewrite popp_at; unfold Rdiv; ring. Qed.
  Lemma esub_at x y : [esub x y] = [x] - [y].
  Proof. unfold esub; rewrite eadd_at, eneg_at; ring. Qed.
  Lemma enum_at q : [enum q] = Q2R q.
  Proof.
    unfold element_at; replace (units_at l us (snd (enum q))) with 1 by (clear nonzero; now destruct us).
    cbn; field.
  Qed.
  Lemma epow_at x n : [epow x n] = [x] ^ n.
  Proof.
    induction n as [|[|n] IH]; [exact (eq_trans (enum_at 1) (morph1 Q_in_R)) | cbn; ring |].
    change (epow x (S (S n))) with (emul x (epow x (S n))); rewrite emul_at, IH; cbn; ring.
  Qed.
  Lemma element_zero x : at_ l (fst x) = 0 -> [x] = 0.
  Proof. intros Z; unfold element_at, Rdiv; rewrite Z; ring. Qed.
End Elements.

(* * Theories *)

Record theory := {
  units : list poly;                   (* do not vanish *)
  relations : list poly;               (* vanish *)
  forms : list (positive * element);   (* names *)
  inverses : list (expr * element);    (* what is divided by, and one over it *)
  slopes : list (expr * element);      (* derivatives by time *)
  meanings : list (positive * expr);   (* abbreviations *)
  signs : list expr                    (* are nonnegative *)
}.
Definition nothing := Build_theory nil nil nil nil nil nil nil.

Record sound (a : R -> list R) (th : theory) : Prop := {
  sound_units t u : In u (units th) -> at_ (a t) u <> 0;
  sound_relations t p : In p (relations th) -> at_ (a t) p = 0;
  sound_forms t k e : In (k, e) (forms th) -> BinList.nth 0 k (a t) = element_at (a t) (units th) e;
  sound_inverses t x e : In (x, e) (inverses th) ->
    value a x t <> 0 /\ / value a x t = element_at (a t) (units th) e;
  sound_slopes t x e : In (x, e) (slopes th) ->
    is_derive (fun s => value a x s) t (element_at (a t) (units th) e);
  sound_meanings t k x : In (k, x) (meanings th) -> BinList.nth 0 k (a t) = value a x t;
  sound_signs t x : In x (signs th) -> 0 <= value a x t
}.

Definition bind {A B} (x : option A) (f : A -> option B) : option B :=
  match x with Some y => f y | None => None end.
Notation "'do' x <- e ; rest" := (bind e (fun x => rest)) (at level 200, x name).
Lemma bind_some {A B} (x : option A) (f : A -> option B) b :
  bind x f = Some b -> exists y, x = Some y /\ f y = Some b.
Proof. destruct x; cbn; [eauto | discriminate]. Qed.
Ltac unbind := repeat match goal with
  | E : bind ?x _ = Some _ |- _ => let y := fresh "y" in let F := fresh "F" in
      destruct (bind_some _ _ _ E) as (y & F & E'); clear E; rename E' into E
  end.

(* One over what is divided by: of the table, or a number. *)
Definition inverse (th : theory) (x : expr) : option element :=
  match x with
  | Num 0 => None
  | Num z => Some (enum (/ inject_Z z))
  | _ => lookup same x (inverses th)
  end.

Fixpoint flat (th : theory) (x : expr) : option element :=
  match x with
  | Num z => Some (enum (inject_Z z))
  | Var k => lookup Pos.eq_dec k (forms th)
  | Neg x => do e <- flat th x; Some (eneg e)
  | Add x y => do e <- flat th x; do f <- flat th y; Some (eadd (units th) e f)
  | Sub x y => do e <- flat th x; do f <- flat th y; Some (esub (units th) e f)
  | Mul x y => do e <- flat th x; do f <- flat th y; Some (emul e f)
  | Div x y => do e <- flat th x; do f <- inverse th y; Some (emul e f)
  | Pow x n => do e <- flat th x; Some (epow e n)
  | Rate x => lookup same x (slopes th)
  end.

(* The derivative by its rules, down to what the table has. *)
Fixpoint slope (th : theory) (x : expr) : option element :=
  match lookup same x (slopes th) with
  | Some e => Some e
  | None =>
      match x with
      | Num _ => Some (enum 0)
      | Neg x => do d <- slope th x; Some (eneg d)
      | Add x y => do d <- slope th x; do f <- slope th y; Some (eadd (units th) d f)
      | Sub x y => do d <- slope th x; do f <- slope th y; Some (esub (units th) d f)
      | Mul x y => do d <- slope th x; do e <- flat th x; do f <- slope th y; do g <- flat th y;
          Some (eadd (units th) (emul d g) (emul e f))
      | Div x y => do d <- slope th x; do e <- flat th x; do f <- slope th y; do i <- inverse th y;
          Some (esub (units th) (emul d i) (emul (emul e f) (emul i i)))
      | Pow x (S n) => do d <- slope th x; do e <- flat th x;
          Some (emul (emul (enum (inject_Z (Z.of_nat (S n)))) d) (epow e n))
      | _ => None
      end
  end.

Lemma Q2R_inject z : Q2R (inject_Z z) = IZR z.
Proof. unfold Q2R; cbn; field. Qed.

Section Sound.
  Variables (a : R -> list R) (th : theory) (S : sound a th).
  Notation at_time t := (element_at (a t) (units th)).
  Let nonzero t := sound_units a th S t.

  Lemma inverse_sound x e t :
    inverse th x = Some e -> value a x t <> 0 /\ / value a x t = at_time t e.
  Proof.
    assert (T : lookup same x (inverses th) = Some e -> value a x t <> 0 /\ / value a x t = at_time t e)
      by (intros E; exact (sound_inverses a th S t x e (lookup_in same _ _ _ E))).
    assert (N : forall z, z <> 0%Z -> Some (enum (/ inject_Z z)) = Some e ->
      IZR z <> 0 /\ / IZR z = at_time t e).
    { intros z Z [= <-]; rewrite enum_at, Q2R_inv, Q2R_inject; [split; auto; now apply not_0_IZR|].
      intros Q; apply Z; unfold Qeq in Q; cbn in Q; lia. }
    destruct x as [[|p|p]| | | | | | | |]; cbn [inverse]; try exact T; try discriminate;
      apply N; discriminate.
  Qed.

  Lemma flat_sound x : forall e t, flat th x = Some e -> value a x t = at_time t e.
  Proof.
    induction x; intros e t; cbn [flat value]; intros E.
    - injection E as <-; now rewrite enum_at, Q2R_inject.
    - exact (sound_forms a th S t k e (lookup_in _ _ _ _ E)).
    - unbind; injection E as <-; rewrite eneg_at; f_equal; auto.
    - unbind; injection E as <-; rewrite eadd_at by apply nonzero; f_equal; auto.
    - unbind; injection E as <-; rewrite esub_at by apply nonzero; f_equal; auto.
    - unbind; injection E as <-; rewrite emul_at by apply nonzero; f_equal; auto.
    - unbind; injection E as <-; rewrite emul_at by apply nonzero.
      destruct (inverse_sound x2 y0 t F0) as [_ I]; unfold Rdiv; rewrite I; f_equal; auto.
    - unbind; injection E as <-; rewrite epow_at by apply nonzero; f_equal; auto.
    - apply is_derive_unique; exact (sound_slopes a th S t x e (lookup_in _ _ _ _ E)).
  Qed.

  Lemma derive_eq (f : R -> R) (t u v : R) : @eq R u v -> is_derive f t u -> is_derive f t v.
  Proof. now intros ->. Qed.

  Lemma slope_sound x : forall e t, slope th x = Some e -> is_derive (fun s => value a x s) t (at_time t e).
  Proof.
    induction x; intros e t; cbn [slope];
      match goal with |- context [lookup same ?x ?table] => destruct (lookup same x table) eqn:L end;
      intros E; try (injection E as <-; exact (sound_slopes a th S t _ _ (lookup_in _ _ _ _ L)));
      clear L; try discriminate; cbn [value].
    - injection E as <-; rewrite enum_at; unfold Q2R; cbn; rewrite Rmult_0_l; apply (is_derive_const (IZR z) t).
    - unbind; injection E as <-; rewrite eneg_at; apply (is_derive_opp (fun s => value a x s)); auto.
    - unbind; injection E as <-; rewrite eadd_at by apply nonzero.
      apply (is_derive_plus (fun s => value a x1 s) (fun s => value a x2 s)); auto.
    - unbind; injection E as <-; rewrite esub_at by apply nonzero.
      apply (is_derive_minus (fun s => value a x1 s) (fun s => value a x2 s)); auto.
    - unbind; injection E as <-; rewrite eadd_at, !emul_at by apply nonzero.
      rewrite <- (flat_sound x1 _ t F0), <- (flat_sound x2 _ t F2).
      apply (is_derive_mult (fun s => value a x1 s) (fun s => value a x2 s)); auto; apply Rmult_comm.
    - unbind; injection E as <-; rewrite esub_at, !emul_at by apply nonzero.
      destruct (inverse_sound x2 _ t F2) as [N I].
      rewrite <- (flat_sound x1 _ t F0), <- I.
      eapply derive_eq; [|apply (is_derive_div (fun s => value a x1 s) (fun s => value a x2 s)); eauto].
      now field.
    - destruct n; [discriminate|]. unbind; injection E as <-.
      rewrite !emul_at, enum_at, epow_at, Q2R_inject by apply nonzero.
      replace (IZR _) with (INR (Datatypes.S n)) by apply INR_IZR_INZ.
      rewrite <- (flat_sound x _ t F0).
      exact (is_derive_pow (fun s => value a x s) (Datatypes.S n) t _ (IHx _ t F)).
  Qed.
End Sound.

(* * Steps: how a theory grows *)

Inductive step :=
  | Generator (k : positive)
  | Define (k : positive) (x : expr)
  (* k abbreviates x, which is y, but for what vanishes: it is known by the form of y. *)
  | Rename (k : positive) (x y : expr) (cofactors : list (list term))
  | Unit (x : expr) | Relation (x : expr) | Sign (x : expr)
  | Moves (k : positive) (x : expr)
  (* x is c times a product of units, but for what vanishes. *)
  | Invert (x : expr) (c : Q) (powers : list nat) (cofactors : list (list term))
  (* The derivative of x is this element, but for what vanishes. *)
  | Differentiate (x : expr) (p : list term) (powers : list nat) (cofactors : list (list term)).

Definition given (a : R -> list R) (s : step) : Prop :=
  match s with
  | Define k x | Rename k x _ _ => forall t, BinList.nth 0 k (a t) = value a x t
  | Unit x => forall t, value a x t <> 0
  | Relation x => forall t, value a x t = 0
  | Sign x => forall t, 0 <= value a x t
  | Moves k x => forall t, is_derive (fun s => BinList.nth 0 k (a s)) t (value a x t)
  | _ => True
  end.

Definition fits (us : list poly) (e : element) : bool := Nat.leb (length (snd e)) (length us).
Definition all_fit (th : theory) : bool :=
  forallb (fun ke => fits (units th) (snd ke)) (forms th)
  && forallb (fun ke => fits (units th) (snd ke)) (inverses th)
  && forallb (fun ke => fits (units th) (snd ke)) (slopes th).
Definition agree (p q : poly) : bool := zero (padd p (popp q)).

Definition meaning (th : theory) (x : expr) : expr :=
  match x with
  | Var k => match lookup Pos.eq_dec k (meanings th) with Some y => y | None => x end
  | _ => x
  end.

Definition take (th : theory) (s : step) : option theory :=
  let (us, rs, fs, js, ds, ms, ss) := th in
  match s with
  | Generator k => Some (Build_theory us rs ((k, (var k, nil)) :: fs) js ds ms ss)
  | Define k x => do e <- flat th x; Some (Build_theory us rs ((k, e) :: fs) js ds ((k, x) :: ms) ss)
  | Rename k x y cofactors => do e <- flat th x; do f <- flat th y;
      if agree (fst (esub us e f)) (combination cofactors rs)
      then Some (Build_theory us rs ((k, f) :: fs) js ds ((k, x) :: ms) ss)
      else None
  | Unit x => do e <- flat th x;
      if all_fit th then Some (Build_theory (us ++ fst e :: nil) rs fs js ds ms ss) else None
  | Relation x => do e <- flat th x; Some (Build_theory us (rs ++ fst e :: nil) fs js ds ms ss)
  | Sign x => Some (Build_theory us rs fs js ds ms (x :: ss))
  | Moves k x => do e <- flat th x; Some (Build_theory us rs fs js ((Var k, e) :: ds) ms ss)
  | Invert x c ks cofactors => do e <- flat th x;
      if negb (Qeq_bool c 0)
         && agree (fst e) (padd (pmul (constant c) (product us ks)) (combination cofactors rs))
      then Some (Build_theory us rs fs ((x, (pmul (constant (/ c)) (product us (snd e)), ks)) :: js) ds ms ss)
      else None
  | Differentiate x p ks cofactors => do d <- slope th (meaning th x);
      let e := (polynomial p, ks) in
      if agree (fst (esub us d e)) (combination cofactors rs)
      then Some (Build_theory us rs fs js ((x, e) :: ds) ms ss)
      else None
  end.

Fixpoint run (th : theory) (steps : list step) : option theory :=
  match steps with nil => Some th | s :: rest => do th <- take th s; run th rest end.
Fixpoint all_given (a : R -> list R) (steps : list step) : Prop :=
  match steps with
  | nil => True
  | (Generator _ | Invert _ _ _ _ | Differentiate _ _ _ _) :: rest => all_given a rest
  | s :: rest => given a s /\ all_given a rest
  end.

Lemma agree_at l p q : agree p q = true -> at_ l p = at_ l q.
Proof. intros E; pose proof (zero_at l _ E) as Z; rewrite padd_at, popp_at in Z; lra. Qed.

Lemma units_grow l us u : forall ks, Nat.leb (length ks) (length us) = true ->
  units_at l (us ++ u :: nil) ks = units_at l us ks.
Proof.
  induction us as [|v us IH]; intros [|k ks] L; cbn in *; try easy. now rewrite IH.
Qed.

Lemma meaning_sound a th x t : sound a th -> value a (meaning th x) t = value a x t.
Proof.
  intros S; destruct x; try easy; cbn. destruct lookup as [y|] eqn:L; [|easy].
  symmetry; exact (sound_meanings a th S t k y (lookup_in _ _ _ _ L)).
Qed.

Lemma take_sound a th s th' : sound a th -> given a s -> take th s = Some th' -> sound a th'.
Proof.
  intros S G T. pose proof (flat_sound a th S) as F. pose proof (slope_sound a th S) as D.
  pose proof (fun t => units_nonzero (a t) (units th) (sound_units a th S t)) as N.
  assert (V : forall x e t, flat th x = Some e ->
    at_ (a t) (fst e) = value a x t * units_at (a t) (units th) (snd e))
    by (intros x e t X; rewrite (F x e t X); unfold element_at; field; apply N).
  pose proof (fun x t => meaning_sound a th x t S) as M.
  destruct th as [us rs fs js ds ms ss]; destruct S as [SU SR SF SI SD SM SS].
  destruct s; cbn [take given] in *; unbind; cbn [units relations forms inverses slopes meanings signs] in *.
  - injection T as <-; constructor; cbn; auto; intros t j e [[= <- <-]|I]; [|auto].
    rewrite <- (var_at (a t) k); unfold element_at; cbn; destruct us; cbn; field.
  - injection T as <-; constructor; cbn; auto.
    + intros t j e [[= <- <-]|I]; [rewrite G; apply F | apply SF]; assumption.
    + intros t j e [[= <- <-]|I]; [apply G | apply SM]; assumption.
  - destruct agree eqn:A in T; [injection T as <- | discriminate].
    constructor; cbn; auto; intros t j e [[= <- <-]|I]; auto.
    apply (agree_at (a t)) in A; rewrite combination_at in A by auto.
    apply (element_zero _ us) in A; rewrite esub_at in A by auto.
    rewrite G, (F _ _ t F0). cbn; lra.
  - destruct all_fit eqn:A in T; [injection T as <- | discriminate].
    unfold all_fit in A; cbn in A; apply andb_prop in A as [A A3]; apply andb_prop in A as [A1 A2].
    rewrite forallb_forall in A1, A2, A3; unfold fits in *.
    assert (P : forall t e, Nat.leb (length (snd e)) (length us) = true ->
      element_at (a t) (us ++ fst y :: nil) e = element_at (a t) us e)
      by (intros t e L; unfold element_at; now rewrite units_grow).
    constructor; cbn; auto.
    + intros t u I; apply in_app_or in I as [I|[<-|[]]]; [auto|].
      rewrite (V _ _ _ F0); apply Rmult_integral_contrapositive_currified; auto.
    + intros t k e I; rewrite P by exact (A1 _ I); auto.
    + intros t k e I; rewrite P by exact (A2 _ I); auto.
    + intros t k e I; rewrite P by exact (A3 _ I); auto.
  - injection T as <-; constructor; cbn; auto.
    intros t p I; apply in_app_or in I as [I|[<-|[]]]; [auto|]. rewrite (V _ _ _ F0), G; ring.
  - injection T as <-; constructor; cbn; auto. intros t j [<-|I]; auto.
  - injection T as <-; constructor; cbn; auto.
    intros t x' e [[= <- <-]|I]; [|auto]. cbn; rewrite <- (F _ _ t F0); apply G.
  - destruct (negb _ && _)%bool eqn:A in T; [injection T as <- | discriminate].
    apply andb_prop in A as [C A]. constructor; cbn; auto.
    intros t x' e [[= <- <-]|I]; [|auto].
    assert (Q : Q2R c <> 0).
    { intros Q; rewrite <- RMicromega.Q2R_0 in Q; apply eqR_Qeq, Qeq_eq_bool in Q; now rewrite Q in C. }
    apply (agree_at (a t)) in A; rewrite padd_at, combination_at, pmul_at, product_at in A by auto.
    change (at_ (a t) (constant c)) with (Q2R c) in A.
    pose proof (V _ _ t F0) as W; rewrite A in W. pose proof (N t powers); pose proof (N t (snd y)).
    assert (X : value a x t <> 0).
    { intros X; rewrite X in W; apply (Rmult_integral_contrapositive_currified _ _ Q (N t powers)); lra. }
    split; [exact X|]. unfold element_at; cbn [fst snd]; rewrite pmul_at, product_at.
    change (at_ (a t) (constant (/ c))) with (Q2R (/ c)).
    rewrite Q2R_inv by (intros Z; rewrite (Qeq_eq_bool _ _ Z) in C; discriminate).
    apply (Rmult_eq_reg_l (value a x t)); [|exact X]; rewrite Rinv_r by exact X.
    replace (value a x t * _) with ((value a x t * units_at (a t) us (snd y)) * / Q2R c
      / units_at (a t) us powers) by (field; auto). rewrite <- W; field; auto.
  - destruct agree eqn:A in T; [injection T as <- | discriminate].
    constructor; cbn; auto. intros t x' e [[= <- <-]|I]; [|auto].
    apply (agree_at (a t)) in A; rewrite combination_at in A by auto.
    apply (element_zero _ us) in A; rewrite esub_at in A by auto.
    apply (is_derive_ext _ _ t _ (fun s => M x s)).
    eapply derive_eq; [|exact (D _ _ t F0)]. cbn; lra.
Qed.

Lemma run_sound a steps : forall th th',
  sound a th -> run th steps = Some th' -> all_given a steps -> sound a th'.
Proof.
  induction steps as [|s rest IH]; intros th th' S E G; cbn in E.
  - now injection E as <-.
  - destruct (take th s) as [next|] eqn:T; [cbn in E | discriminate].
    assert (B : given a s /\ all_given a rest) by (destruct s; cbn in *; tauto).
    exact (IH next th' (take_sound a th s next S (proj1 B) T) E (proj2 B)).
Qed.

Lemma nothing_sound a : sound a nothing.
Proof. constructor; cbn; tauto. Qed.

(* * Claims *)

Inductive claim :=
  | Equal (x y : expr)
  | Derives (x y : expr)    (* y is the derivative of x *)
  | Smooth (x : expr)       (* x has a derivative *)
  | Root (x y : expr)       (* x is the root of y that is not negative *)
  | Nonnegative (x : expr)
  | AtLeast (x y : expr)    (* x is y, which is not negative *)
  | Nonzero (x : expr).

Definition states (a : R -> list R) (t : R) (c : claim) : Prop :=
  match c with
  | Equal x y => value a x t = value a y t
  | Derives x y => is_derive (fun s => value a x s) t (value a y t)
  | Smooth x => ex_derive (fun s => value a x s) t
  | Root x y => value a x t = sqrt (value a y t)
  | Nonnegative x | AtLeast x _ => 0 <= value a x t
  | Nonzero x => value a x t <> 0
  end.
(* A claim with the cofactors that decide it. *)
Definition certified := (claim * list (list term))%type.
Fixpoint all_state (a : R -> list R) (t : R) (cs : list certified) : Prop :=
  match cs with
  | nil => True
  | (c, _) :: nil => states a t c
  | (c, _) :: rest => states a t c /\ all_state a t rest
  end.

(* Seen to be not negative: signs, and what is made of them by + * / and even powers. *)
Fixpoint visible (fuel : nat) (th : theory) (x : expr) : bool :=
  match fuel with
  | O => false
  | S fuel =>
      if in_dec same x (signs th) then true else
      match x with
      | Num z => Z.leb 0 z
      | Var k => match lookup Pos.eq_dec k (meanings th) with Some y => visible fuel th y | None => false end
      | Pow y n => Nat.even n || visible fuel th y
      | Add y z | Mul y z | Div y z => visible fuel th y && visible fuel th z
      | _ => false
      end
  end.

Definition matches (th : theory) (cofactors : list (list term)) (x y : option element) : bool :=
  match x, y with
  | Some e, Some f => agree (fst (esub (units th) e f)) (combination cofactors (relations th))
  | _, _ => false
  end.
Definition check (th : theory) (c : certified) : bool :=
  match c with
  | (Equal x y, cofactors) => matches th cofactors (flat th x) (flat th y)
  | (Derives x y, cofactors) => matches th cofactors (slope th x) (flat th y)
  | (Smooth x, _) => match slope th x with Some _ => true | None => false end
  | (Root x y, cofactors) => visible 200 th x && matches th cofactors (flat th (Pow x 2)) (flat th y)
  | (Nonnegative x, _) => visible 200 th x
  | (AtLeast x y, cofactors) => visible 200 th y && matches th cofactors (flat th x) (flat th y)
  | (Nonzero x, _) => match inverse th x with Some _ => true | None => false end
  end.

Lemma divided_nonnegative x y : 0 <= x -> 0 <= y -> 0 <= x / y.
Proof.
  intros X [Y|<-]; unfold Rdiv; [|rewrite Rinv_0; lra].
  apply Rmult_le_pos; [exact X | left; now apply Rinv_0_lt_compat].
Qed.
Lemma even_power_nonnegative x n : Nat.even n = true -> 0 <= x ^ n.
Proof.
  intros E; apply Nat.even_spec in E as [k ->]; rewrite pow_mult; apply pow_le, pow2_ge_0.
Qed.

Section Decided.
  Variables (a : R -> list R) (th : theory) (S : sound a th).

  Lemma visible_sound fuel : forall x t, visible fuel th x = true -> 0 <= value a x t.
  Proof.
    induction fuel as [|fuel IH]; intros x t V; [discriminate|]; cbn in V.
    destruct in_dec as [I|_]; [exact (sound_signs a th S t x I)|].
    destruct x; try discriminate; cbn [value].
    - apply IZR_le; now apply Z.leb_le.
    - destruct lookup as [y|] eqn:L; [|discriminate].
      rewrite (sound_meanings a th S t k y (lookup_in _ _ _ _ L)); auto.
    - apply andb_prop in V as [X Y]; apply Rplus_le_le_0_compat; auto.
    - apply andb_prop in V as [X Y]; apply Rmult_le_pos; auto.
    - apply andb_prop in V as [X Y]; apply divided_nonnegative; auto.
    - apply orb_prop in V as [E|X]; [now apply even_power_nonnegative | apply pow_le; auto].
  Qed.

  Lemma matches_sound cofactors x y t : matches th cofactors x y = true ->
    exists e f, x = Some e /\ y = Some f /\
      element_at (a t) (units th) e = element_at (a t) (units th) f.
  Proof.
    destruct x as [e|], y as [f|]; try discriminate; intros M; exists e, f; do 2 (split; [easy|]).
    apply (agree_at (a t)) in M; rewrite combination_at in M by exact (sound_relations a th S t).
    apply (element_zero _ (units th)) in M; rewrite esub_at in M by exact (sound_units a th S t); lra.
  Qed.

  Lemma equal_sound cofactors x y t :
    matches th cofactors (flat th x) (flat th y) = true -> value a x t = value a y t.
  Proof.
    intros M; destruct (matches_sound _ _ _ t M) as (e & f & X & Y & E).
    now rewrite (flat_sound a th S x e t X), (flat_sound a th S y f t Y).
  Qed.

  Lemma check_sound c t : check th c = true -> states a t (fst c).
  Proof.
    destruct c as [[x y|x y|x|x y|x|x y|x] cofactors]; cbn [check fst states]; intros C.
    - now apply (equal_sound cofactors).
    - destruct (matches_sound _ _ _ t C) as (e & f & X & Y & E).
      rewrite (flat_sound a th S y f t Y), <- E; now apply slope_sound.
    - destruct (slope th x) as [e|] eqn:E; [|discriminate].
      exists (element_at (a t) (units th) e); now apply slope_sound.
    - apply andb_prop in C as [V C]; apply equal_sound with (t := t) in C.
      rewrite <- C; cbn [value]; symmetry; apply sqrt_pow2; now apply (visible_sound 200).
    - now apply (visible_sound 200).
    - apply andb_prop in C as [V C]; rewrite (equal_sound cofactors x y t C).
      now apply (visible_sound 200).
    - destruct (inverse th x) as [e|] eqn:E; [|discriminate].
      now apply (inverse_sound a th S x e t).
  Qed.

  Theorem decided cs t : forallb (check th) cs = true -> all_state a t cs.
  Proof.
    induction cs as [|[c w] [|d rest] IH]; cbn [all_state]; intros C; [easy | |];
      apply andb_prop in C as [C D]; [exact (check_sound (c, w) t C)|].
    split; [exact (check_sound (c, w) t C) | exact (IH D)].
  Qed.
End Decided.

(* * What is carried from one context to another: claims whose sides are equal there. *)

(* What is stated there, what is stated here, and cofactors for both sides. *)
Definition carriage := (claim * claim * (list (list term) * list (list term)))%type.
Definition carries (th : theory) (c : carriage) : bool :=
  let (cd, ws) := c in
  let equal x y w := matches th w (flat th x) (flat th y) in
  match cd with
  | (Equal x y, Equal x' y') => equal x x' (fst ws) && equal y y' (snd ws)
  | (Derives x y, Derives x' y') => equal x x' (fst ws) && equal y y' (snd ws)
  | (Root x y, Root x' y') => equal x x' (fst ws) && equal y y' (snd ws)
  | (Nonnegative x, Nonnegative x') | (Smooth x, Smooth x') => equal x x' (fst ws)
  | _ => false
  end.

Lemma carried_one a th c t : sound a th -> carries th c = true ->
  states a t (fst (fst c)) -> states a t (snd (fst c)).
Proof.
  intros S; destruct c as [[c d] [v w]]; unfold carries; cbn [fst snd].
  destruct c, d; try discriminate; cbn [states]; intros C;
    try (apply andb_prop in C as [C D]; pose proof (equal_sound a th S w _ _ t D));
    pose proof (fun s => equal_sound a th S v _ _ s C) as E; try pose proof (E t); try congruence.
  - replace (value a y0 t) with (value a y t) by assumption. apply is_derive_ext, E.
  - apply ex_derive_ext, E.
Qed.

Theorem carried a th cs t : sound a th -> forallb (carries th) cs = true ->
  all_state a t (map (fun c => (fst (fst c), nil)) cs) -> all_state a t (map (fun c => (snd (fst c), nil)) cs).
Proof.
  intros S; induction cs as [|c [|d rest] IH]; intros C; [easy | |]; apply andb_prop in C as [C D].
  - exact (carried_one a th c t S C).
  - intros [A B]; split; [exact (carried_one a th c t S C A) | exact (IH D B)].
Qed.

(* How files write terms; and what they leave to computation, when Coq checks the proof. *)
Definition ratio : Z -> positive -> Q := Qmake.
Definition mono (n : Z) (d : positive) (m : list (positive * nat)) : term := (ratio n d, m).
Definition pw (k : positive) (n : nat) : positive * nat := (k, n).

(* * Cases *)

Definition exactly_one (ps : list Prop) : Prop :=
  exists i, List.nth i ps False /\ forall j, List.nth j ps False -> j = i.

(* Whatever has P has exactly one of these, and each of these has P. *)
Definition splits (P : Prop) (ps : list Prop) : Prop :=
  (P -> exactly_one ps) /\ forall i, List.nth i ps False -> P.

Lemma splits_itself P : splits P (P :: nil).
Proof.
  split; [intros H; exists O; split; [exact H|] |]; intros [|[|j]] J; cbn in J; tauto.
Qed.

Lemma in_one_of P qs : forall i, List.nth i (P ++ qs) False ->
  (i < length P /\ List.nth i P False \/ i >= length P /\ List.nth (i - length P) qs False)%nat.
Proof.
  intros i I; destruct (Nat.lt_ge_cases i (length P)) as [L|L]; [left | right]; split; auto.
  - now rewrite app_nth1 in I.
  - now rewrite app_nth2 in I.
Qed.

(* Cases of a case, in its place. *)
Lemma splits_first P A As ps : splits A As -> splits P (A :: ps) -> splits P (As ++ ps).
Proof.
  intros [A1 A2] [P1 P2]; split.
  - intros H; destruct (P1 H) as ([|i] & I & U); cbn in I.
    + destruct (A1 I) as (j & J & V). exists j; split.
      * destruct (Nat.lt_ge_cases j (length As)) as [L|L]; [now rewrite app_nth1 |].
        rewrite nth_overflow in J by lia; contradiction.
      * intros k K; destruct (in_one_of As ps k K) as [[_ K']|[_ K']]; [auto|].
        discriminate (U (S (k - length As))%nat K').
    + exists (length As + i)%nat; split.
      * rewrite app_nth2 by lia; now replace (length As + i - length As)%nat with i by lia.
      * intros k K; destruct (in_one_of As ps k K) as [[_ K']|[G K']].
        -- discriminate (U O (A2 k K')).
        -- specialize (U (S (k - length As))%nat K'); lia.
  - intros i I; destruct (in_one_of As ps i I) as [[_ I']|[_ I']].
    + exact (P2 O (A2 i I')).
    + exact (P2 (S (i - length As)) I').
Qed.
Lemma splits_rotate P ps qs : splits P (ps ++ qs) -> splits P (qs ++ ps).
Proof.
  assert (turn : forall ps qs i, List.nth i (ps ++ qs) False -> exists j,
    List.nth j (qs ++ ps) False /\ (i < length ps /\ j = length qs + i \/ i = length ps + j)%nat).
  { intros us vs i I; destruct (in_one_of us vs i I) as [[L I']|[L I']].
    - exists (length vs + i)%nat; split; [|now left].
      rewrite app_nth2 by lia; now replace (length vs + i - length vs)%nat with i by lia.
    - exists (i - length us)%nat; split; [|right; lia].
      destruct (Nat.lt_ge_cases (i - length us) (length vs)) as [M|M]; [now rewrite app_nth1 |].
      now rewrite nth_overflow in I' by lia. }
  intros [A B]; split.
  - intros H; destruct (A H) as (i & I & U); destruct (turn ps qs i I) as (j & J & E).
    exists j; split; [exact J|]. intros k K; destruct (turn qs ps k K) as (m & M & F).
    pose proof (U m M); subst m.
    assert (i < length (ps ++ qs))%nat
      by (apply Nat.nle_gt; intros L; now rewrite nth_overflow in I by exact L).
    assert (k < length (qs ++ ps))%nat
      by (apply Nat.nle_gt; intros L; now rewrite nth_overflow in K by exact L).
    rewrite app_length in *; lia.
  - intros i I; destruct (turn qs ps i I) as (j & J & _); exact (B j J).
Qed.

(* The sign of a number: zero, positive, negative. *)
Lemma splits_by_sign (P A B C : Prop) (x : R) :
  (A <-> P /\ x = 0) -> (B <-> P /\ x <> 0 /\ 0 <= x) -> (C <-> P /\ x <> 0 /\ 0 <= - x) ->
  splits P (A :: B :: C :: nil).
Proof.
  intros a b c; split.
  - intros H; destruct (total_order_T x 0) as [[L|E]|G].
    + exists 2%nat; split; [apply c; repeat split; (assumption || lra) |].
      intros [|[|[|[|j]]]] J; cbn in J; try easy.
      * apply a in J; lra.
      * apply b in J; lra.
    + exists 0%nat; split; [now apply a|].
      intros [|[|[|[|j]]]] J; cbn in J; try easy; [apply b in J | apply c in J]; tauto.
    + exists 1%nat; split; [apply b; repeat split; (assumption || lra) |].
      intros [|[|[|[|j]]]] J; cbn in J; try easy.
      * apply a in J; lra.
      * apply c in J; lra.
  - intros [|[|[|[|j]]]] J; cbn in J; try tauto.
Qed.
Lemma splits_by_size (P A B : Prop) (x : R) :
  (P -> 0 <= x) -> (A <-> P /\ x = 0) -> (B <-> P /\ x <> 0 /\ 0 <= x) -> splits P (A :: B :: nil).
Proof.
  intros p a b; split.
  - intros H; specialize (p H); destruct (Req_dec x 0) as [E|N].
    + exists 0%nat; split; [now apply a|].
      intros [|[|[|j]]] J; cbn in J; try easy; apply b in J; tauto.
    + exists 1%nat; split; [now apply b|].
      intros [|[|[|j]]] J; cbn in J; try easy; apply a in J; tauto.
  - intros [|[|[|j]]] J; cbn in J; tauto.
Qed.
