"""Answers, in the shapes of the JSON Schema."""

from giveway.answers.certificates import Certificate, Certificates, Report
from giveway.answers.changed import ChangeAnswer, ChangeStep, MethodAnswer
from giveway.answers.costs import Costs, Ended, Stats, Status
from giveway.answers.drawn import on
from giveway.answers.explained import (
    AgentDelay, Alone, Delays, Explanation, Freedom, FreedomPart, Order, Prices, RulePrice, Sizing, SizingPoint, Together,
)
from giveway.answers.files import Converted, Files, ForeignPlan, Format
from giveway.answers.judged import AgentComparison, AuditAnswer, Comparison, Verdict, Violation
from giveway.answers.solved import Answer, Front, Planner, PlannerAnswer, PlannerStats

__all__ = [
    "AgentComparison", "AgentDelay", "Alone", "Answer", "AuditAnswer", "Certificate", "Certificates", "ChangeAnswer", "ChangeStep",
    "Comparison", "Converted", "Costs", "Delays", "Ended", "Explanation", "Files", "ForeignPlan", "Format", "Freedom", "FreedomPart",
    "Front", "MethodAnswer", "Order", "Planner", "PlannerAnswer", "PlannerStats", "Prices", "Report", "RulePrice", "Sizing",
    "SizingPoint", "Stats", "Status",
    "Together", "Verdict", "Violation", "on",
]
