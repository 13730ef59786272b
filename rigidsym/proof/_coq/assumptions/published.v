(* What the theorems on published forms rest on, all of them together: the same axioms. *)
From Rigidsym.theorems Require Import published.

Definition published := (@descended_motion, @theta_form_motion, @hyperbolic_form_motion,
  @separatrix_form_motion, @symmetric_form_motion, @pi_near_motion, @pi_far_motion).
Print Assumptions published.
