(* What the theorems on published forms rest on, all of them together: the same axioms. *)
From Rigidsym.theorems Require Import published instances.

Definition published := (@descended_motion, @theta_form_motion, @hyperbolic_form_motion,
  @separatrix_form_motion, @symmetric_form_motion, @pi_near_motion, @pi_far_motion,
  @descended_instance, @descended_from_start, @descended_by_sines, @descended_by_tanh,
  @separatrix_form_instance, @theta_form_instance, @hyperbolic_form_instance, @symmetric_form_instance,
  @pi_near_instance, @pi_near_by_tanh, @pi_far_instance).
Print Assumptions published.
