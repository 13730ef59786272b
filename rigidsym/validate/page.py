def page(data):
    return "<html></html>"
