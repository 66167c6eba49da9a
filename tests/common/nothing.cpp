// nothing.cpp — a target of headers needs a file.
