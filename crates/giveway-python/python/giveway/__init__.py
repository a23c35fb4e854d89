"""Giveway: best plans for several robots on a grid, with a proof, and explanations."""

from giveway._door import Progress
from giveway._native import VERSION as __version__
from giveway.answers import (
    AgentComparison, AgentDelay, Alone, Answer, AuditAnswer, Certificate, Certificates, ChangeAnswer, ChangeStep, Comparison, Converted,
    Costs, Delays, Ended, Explanation, Files, ForeignPlan, Format, Freedom, FreedomPart, Front, MethodAnswer, Order, Planner, PlannerAnswer,
    PlannerStats, Prices, Report, RulePrice, Sizing, SizingPoint, Stats, Status, Together, Verdict, Violation,
)
from giveway.errors import BadInput, BadScene, BadText, Broken, Fault, GivewayError
from giveway.files import convert, read_files, verify, verify_archive
from giveway.functions import (
    Objective, audit, change, check, compare, delays, explain, export, freedom, order, pareto, price, schema, sizing,
    solve, together,
)
from giveway.plan import Animation, Plan
from giveway.scene import Agent, Assumption, Battery, Cell, Cost, Rules, Scene

__all__ = [
    "Agent", "AgentComparison", "AgentDelay", "Alone", "Animation", "Answer", "Assumption", "AuditAnswer", "BadInput", "BadScene",
    "BadText", "Battery", "Broken", "Cell", "Certificate", "Certificates", "ChangeAnswer", "ChangeStep", "Comparison", "Converted", "Cost",
    "Costs", "Delays", "Ended", "Explanation", "Fault", "Files", "ForeignPlan", "Format", "Freedom", "FreedomPart", "Front",
    "GivewayError", "MethodAnswer", "Objective", "Order", "Plan", "Planner", "PlannerAnswer", "PlannerStats", "Prices", "Progress", "Report",
    "RulePrice", "Rules", "Scene", "Sizing", "SizingPoint", "Stats", "Status", "Together", "Verdict", "Violation", "__version__", "audit", "change", "check", "compare",
    "convert", "delays", "explain", "export", "freedom", "order", "pareto", "price", "read_files", "schema", "sizing", "solve", "together", "verify",
    "verify_archive",
]
