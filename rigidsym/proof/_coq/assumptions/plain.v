(* What the theorems in plain words rest on, all of them together: axioms of Coq's real numbers. *)
From Rigidsym.theorems Require Import motion steady symmetric asymmetric separatrix.

Definition plain :=
  (@unique, @rest, @steady_motion, @symmetric_motion, @asymmetric_motion, @separatrix_motion).
Print Assumptions plain.
