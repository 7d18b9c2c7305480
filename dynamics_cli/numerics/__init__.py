"""Mathematics without physics: the elementary functions every formula uses, and what proves their error."""
