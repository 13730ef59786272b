(* What the theorems in plain words rest on: axioms of Coq's real numbers, and nothing else. *)
From Rigidsym Require Import theorems.

Print Assumptions steady_motion.
