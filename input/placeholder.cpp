namespace input {}
