"""The methods that lost: textbook forms and alternatives, kept here to show why the chosen ones were chosen."""
