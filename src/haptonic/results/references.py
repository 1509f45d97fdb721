class References:
    read = None
