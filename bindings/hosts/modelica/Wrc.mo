package Wrc "Wheel/rail contact: libwrc as external functions"
  type Inputs = Real[18] "y, z, roll, yaw; velocity; rates of roll, pitch, yaw; rail y, z, roll, velocities of its material, rate of roll, slopes dy/dx, dz/dx; SI";
  type Wrench = Real[6] "force, moment on the wheel about the middle of the wheelset, track axes [N, N.m]";

  class Wheel "One wheel on its rail"
    extends ExternalObject;
    function constructor
      input Integer side "0: right, 1: left";
      input Integer wheelProfile = 2 "enum wrc_profile_kind: S1002";
      input Integer railProfile = 4 "3: 60E1, 4: UIC60 of the Manchester benchmark";
      input Real inclination = 0 "tangent of the rails' cant";
      input Real friction = 0.3;
      output Wheel wheel;
      external "C" wheel = wrc_modelica_open(side, wheelProfile, railProfile, inclination, friction)
        annotation(Include = "#include \"wrc_modelica.h\"", Library = "wrc");
    end constructor;
    function destructor
      input Wheel wheel;
      external "C" wrc_modelica_close(wheel) annotation(Include = "#include \"wrc_modelica.h\"", Library = "wrc");
    end destructor;
  end Wheel;

  function wrench "of the rail on the wheel; derivatives are exact"
    input Wheel wheel;
    input Inputs u;
    output Wrench w;
    external "C" wrc_modelica_wrench(wheel, u, w) annotation(Include = "#include \"wrc_modelica.h\"", Library = "wrc");
    annotation(derivative(noDerivative = wheel) = wrench_der);
  end wrench;

  function wrench_der
    input Wheel wheel;
    input Inputs u;
    input Real[18] du;
    output Real[6] dw;
    external "C" wrc_modelica_wrench_der(wheel, u, du, dw) annotation(Include = "#include \"wrc_modelica.h\"", Library = "wrc");
  end wrench_der;

  model Drop "A wheelset's half on its rail, from 0.1 mm above"
    parameter Real mass = 8000, damping = 4e4;
    Wheel wheel = Wheel(0);
    Real z(start = 0.1e-3, fixed = true), v(start = 0, fixed = true);
    Wrench w = wrench(wheel, {0, z, 0, 0, 20, 0, v, 0, -20/0.46, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  equation
    der(z) = v;
    mass*der(v) = mass*9.81 + w[3] - damping*v;
  end Drop;
end Wrc;
