"""Forces: resultants, moments, equivalent systems, supports, springs, gravity, friction."""
