"""Giveway: best plans for several robots on a grid, with a proof, and explanations."""

from giveway._door import Progress
from giveway._native import VERSION as __version__
from giveway.answers import (
    Alone, Answer, AuditAnswer, Certificate, Certificates, ChangeAnswer, ChangeStep, Converted, Costs, Explanation, Freedom,
    Front, MethodAnswer, PlannerAnswer, Report, Stats, Together, Verdict, Violation,
)
from giveway.errors import BadInput, BadScene, BadText, Broken, Fault, GivewayError
from giveway.functions import (
    audit, change, check, convert, explain, export, freedom, pareto, schema, solve, together, verify,
    verify_archive,
)
from giveway.plan import Animation, Plan
from giveway.scene import Agent, Battery, Cell, Cost, Rules, Scene

__all__ = [
    "Agent", "Alone", "Animation", "Answer", "AuditAnswer", "BadInput", "BadScene", "BadText", "Battery", "Broken", "Cell",
    "Certificate", "Certificates", "ChangeAnswer", "ChangeStep", "Converted", "Cost", "Costs", "Explanation", "Fault",
    "Freedom", "Front", "GivewayError", "MethodAnswer", "Plan", "PlannerAnswer", "Progress", "Report", "Rules", "Scene",
    "Stats", "Together", "Verdict", "Violation", "__version__", "audit", "change", "check", "convert", "explain", "export",
    "freedom", "pareto", "schema", "solve", "together", "verify", "verify_archive",
]
