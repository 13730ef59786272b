(* What the theorems on steps and kicks rest on, all of them together: the same axioms. *)
From Rigidsym.theorems Require Import kick step.

Definition computed := (@kick_torque, @each_start_has_a_side, @step_motion, @step_by_doubling).
Print Assumptions computed.
