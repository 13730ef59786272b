(* What the theorems on steps, kicks and sensitivities rest on, all of them together: the same axioms. *)
From Rigidsym.theorems Require Import kick step variation.

Definition computed :=
  (@kick_torque, @each_start_has_a_side, @step_motion, @step_by_doubling, @derivatives_of_rates).
Print Assumptions computed.
