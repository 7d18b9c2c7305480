"""Where inputs come from: files, results of earlier documents, preferences."""
