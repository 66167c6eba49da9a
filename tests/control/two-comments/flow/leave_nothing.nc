%
(rule: what leaves no loop is an alarm)
(expect: alarm  K5435 at 4:1)
LEAVE
M2
