%
O0001 (dialect: fanuc)
N10 G90 G54 G0 X0
N20 #1=5
N30 M98 P200
N40 G65 P300 A1.5
N50 X1.
N60 M98 P200
N70 M30
O0200
N210 X#1
N220 G65 P300 A2.
N230 M99
O0300
N310 Y#1
N320 M99
%
;? break N30
;? break N220
;? :next
;? :step
;? :step
;? :next
;? :vars
;? :out
;? :step
;? :vars
;? :out
;? :next
;? :out
;? :break 300
;? :c
;? :out
;? :out
;? :c
;> levels.nc:5: stopped before `N30`
;>    5 | N30 M98 P200
;>      | ^
;> position  X0.000 Y0.000 Z0.000
;> machine   X0.000 Y0.000 Z0.000
;> > :next
;> levels.nc:12: stopped before `N220`
;>   12 | N220 G65 P300 A2.
;>      | ^
;> position  X5.000 Y0.000 Z0.000
;> machine   X5.000 Y0.000 Z0.000
;> > :step
;> levels.nc:14: stopped
;>   14 | O0300
;>      | ^
;> position  X5.000 Y0.000 Z0.000
;> machine   X5.000 Y0.000 Z0.000
;> > :step
;> levels.nc:15: stopped
;>   15 | N310 Y#1
;>      | ^
;> position  X5.000 Y0.000 Z0.000
;> machine   X5.000 Y0.000 Z0.000
;> > :next
;> levels.nc:16: stopped
;>   16 | N320 M99
;>      | ^
;> position  X5.000 Y2.000 Z0.000
;> machine   X5.000 Y2.000 Z0.000
;> > :vars
;> #1 = 2
;> > :out
;> levels.nc:13: stopped
;>   13 | N230 M99
;>      | ^
;> position  X5.000 Y2.000 Z0.000
;> machine   X5.000 Y2.000 Z0.000
;> > :step
;> levels.nc:6: stopped
;>    6 | N40 G65 P300 A1.5
;>      | ^
;> position  X5.000 Y2.000 Z0.000
;> machine   X5.000 Y2.000 Z0.000
;> > :vars
;> #1 = 5
;> > :out
;> nothing has called this program: `:continue` goes on to its end
;> > :next
;> levels.nc:7: stopped
;>    7 | N50 X1.
;>      | ^
;> position  X5.000 Y1.500 Z0.000
;> machine   X5.000 Y1.500 Z0.000
;> > :out
;> nothing has called this program: `:continue` goes on to its end
;> > :break 300
;> > :c
;> levels.nc:12: stopped before `N220`
;>   12 | N220 G65 P300 A2.
;>      | ^
;> position  X5.000 Y1.500 Z0.000
;> machine   X5.000 Y1.500 Z0.000
;> > :out
;> levels.nc:14: stopped before `300`
;>   14 | O0300
;>      | ^
;> position  X5.000 Y1.500 Z0.000
;> machine   X5.000 Y1.500 Z0.000
;> > :out
;> levels.nc:13: stopped
;>   13 | N230 M99
;>      | ^
;> position  X5.000 Y2.000 Z0.000
;> machine   X5.000 Y2.000 Z0.000
;> > :c
;> exit status 0
