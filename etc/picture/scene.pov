// SPDX-License-Identifier: GPL-3.0-or-later
// A flume with grains and water at one or more moments, for POV-Ray 3.7. Its x is along
// the flume, y away from its base, z across. etc/rayTrace sets
//
//   UpX UpZ            direction against gravity, in the run's x and z
//   X0 X1 Y0 Y1 Z1     the flume: from to along and across, height shown, m
//   Azimuth Elevation  from where it is seen, degrees; 0 0 is square from the side
//   Apart              from the flume of a moment down to that of the next, m
//   Drawn              1: walls are the bodies of solids.inc, in place of base and far wall
//   Moments            how many; in this folder of each: grains<n>.inc, water<n>.inc
//   Fastest            m/s, of the last colour of the grains; 0: colours are types
//
// and times.inc, which sets these and Label[n].

#version 3.7;
#include "times.inc"
#if (Drawn) #include "solids.inc" #end
global_settings { assumed_gamma 1.0 max_trace_level 10 }
background { rgb 1 }

#declare Up = vnormalize(<UpX, UpZ, 0>);
#declare Along = vcross(Up, z);
#declare Length = X1 - X0;
#declare Unit = max(Length, Z1);
#declare Thick = 0.006*Unit;
#declare Sign = min(Z1, 0.12*Unit);

// Camera: as far off as twice what it sees, its frame just around all
#declare Level = cos(radians(Elevation));
#declare Ahead = z*Level*cos(radians(Azimuth)) - Along*Level*sin(radians(Azimuth))
    - Up*sin(radians(Elevation));
#declare Sideways = vnormalize(vcross(Up, Ahead));
#declare Upwards = vcross(Ahead, Sideways);
#if (Apart = 0) #declare Apart = 1.4*Z1; #end
#declare Shift = -Up*Apart;
#declare Middle = <(X0 + X1)/2, Z1/2, (Y0 + Y1)/2> + Shift*(Moments - 1)/2;
#declare Eye = Middle - Ahead*2.2*max(Unit, Apart*Moments);
#declare LowU = 1e9; #declare HighU = -1e9;
#declare LowV = 1e9; #declare HighV = -1e9;
#for (M, 0, Moments - 1)
    #for (I, 0, 7)
        #local Corner = <(mod(I, 2) > 0 ? X1 : X0 - Thick), (mod(int(I/2), 2) > 0 ? Z1 : -5*Thick),
            Y0 + (Y1 - Y0)*int(I/4)> + Shift*M - Eye;
        #local U = vdot(Corner, Sideways)/vdot(Corner, Ahead);
        #local V = vdot(Corner, Upwards)/vdot(Corner, Ahead);
        #declare LowU = min(LowU, U); #declare HighU = max(HighU, U);
        #declare LowV = min(LowV, V); #declare HighV = max(HighV, V);
    #end
#end
#declare Aspect = image_width/image_height;
#declare Wide = 1.02*max(HighU - LowU, (HighV - LowV)*Aspect);
camera
{
    location Eye
    direction Ahead + Sideways*(LowU + HighU)/2 + Upwards*(LowV + HighV)/2
    right Sideways*Wide
    up Upwards*Wide/Aspect
}

light_source
{
    Middle - Along*0.8*Unit + Up*2*Unit - z*1.6*Unit
    rgb 1.15
    area_light Along*0.35*Unit, z*0.35*Unit, 4, 4 adaptive 1 jitter
}
light_source { Eye + Along*Unit rgb 0.28 shadowless }

// Colours of the grains: types 1 to 4, or eight from rest to fast; six shades each
#declare Hue = array[8]
#if (Fastest > 0)
    #declare Hue[0] = <0.13, 0.16, 0.36>; #declare Hue[1] = <0.16, 0.30, 0.52>;
    #declare Hue[2] = <0.15, 0.46, 0.53>; #declare Hue[3] = <0.25, 0.60, 0.46>;
    #declare Hue[4] = <0.52, 0.70, 0.33>; #declare Hue[5] = <0.85, 0.73, 0.25>;
    #declare Hue[6] = <0.93, 0.50, 0.18>; #declare Hue[7] = <0.83, 0.22, 0.13>;
#else
    #declare Hue[0] = <0.72, 0.47, 0.23>; #declare Hue[1] = <0.40, 0.39, 0.38>;
    #declare Hue[2] = <0.50, 0.20, 0.14>; #declare Hue[3] = <0.55, 0.55, 0.50>;
#end
#declare Colour = array[8][6]
#for (I, 0, (Fastest > 0 ? 7 : 3))
    #for (J, 0, 5)
        #declare Colour[I][J] = texture
        {
            pigment { rgb Hue[I]*(0.82 + 0.07*J) }
            finish { ambient 0.12 diffuse 0.75 specular 0.15 roughness 0.03 }
        }
    #end
#end

#declare Water = material
{
    texture
    {
        pigment { rgbf <0.80, 0.93, 1, 0.9> }
        finish
        {
            ambient 0 diffuse 0.12 specular 0.8 roughness 0.003
            reflection { 0.03, 0.6 fresnel } conserve_energy
        }
    }
    interior { ior 1.2 fade_distance 0.07 fade_power 1001 fade_color <0.10, 0.42, 0.72> }
}

#declare Film = texture
{
    pigment { rgbf <0.35, 0.60, 0.85, 0.55> }
    finish { ambient 0.1 diffuse 0.4 specular 0.6 roughness 0.005 reflection { 0.02, 0.3 } }
}

// Base, wall at the far side, wall at the upper end; marks along the base
#declare Plain = texture
{
    pigment { rgb <0.80, 0.82, 0.84> } finish { ambient 0.2 diffuse 0.7 }
}
#declare Built = texture
{
    pigment { rgb <0.52, 0.50, 0.47> } finish { ambient 0.2 diffuse 0.7 }
}
#declare Ink = texture { pigment { rgb 0.08 } finish { ambient 1 diffuse 0 } }
#macro Text(Words, Size, Place)
    text
    {
        internal 2 Words 0.001, 0 scale Size texture { Ink } no_shadow translate Place
    }
#end
#declare Step = (Length > 2 ? 1 : (Length > 1 ? 0.5 : (Length > 0.5 ? 0.2 : 0.05)));
#declare Flume = union
{
    #if (Drawn)
        box { <X0, -5*Thick, Y0 - Thick>, <X1, 0, Y0> }
        intersection
        {
            union { Bodies() }
            box { <X0, -5*Thick, Y0>, <X1, 10*Unit, 10*Unit> }
        }
    #else
        box { <X0 - Thick, -5*Thick, Y0 - Thick>, <X1, 0, Y1 + Thick> }
        box { <X0 - Thick, 0, Y1>, <X1, Z1, Y1 + Thick> }
    #end
    #if (Back) box { <X0 - Thick, 0, Y0>, <X0, Z1, Y1> } #end
    #for (I, max(0, ceil(X0/Step)), floor(X1/Step - 0.1))
        box
        {
            <I*Step - 0.001*Unit, -1.2*Thick, -0.0005*Unit>, <I*Step + 0.001*Unit, 0, 0>
            translate (Y0 - Thick)*z texture { Ink }
        }
        Text(concat(str(I*Step, 0, (Step < 1 ? (Step < 0.1 ? 2 : 1) : 0)), " m"),
            4*Thick, <I*Step + 0.004*Unit, -4.3*Thick, Y0 - 1.1*Thick>)
    #end
    texture { Plain } no_shadow
}

// What the colours of speed are
#if (Fastest > 0)
#declare Legend = union
{
    #for (I, 0, 7)
        box
        {
            <0.025*I, 0, -1e-3>*Unit, <0.025*(I + 1), 0.02, 0>*Unit
            texture { Colour[I][2] }
        }
    #end
    Text(concat("0 to ", str(Fastest, 0, 1), " m/s"), 0.022*Unit, <0.21, 0.002, 0>*Unit)
}
#end

#for (M, 0, Moments - 1)
    union
    {
        object { Flume }
        #if (Fastest > 0 & M = 0)
            object { Legend translate <X1 - 0.62*Unit, Z1 - 0.035*Unit, Y1 - 0.1*Thick> }
        #end
        Text(Label[M], 0.45*Sign, <X1 - 0.16*Unit, Z1 - 0.42*Sign, Y1 - 0.1*Thick>)
        #include concat("grains", str(M, 0, 0), ".inc")
        #include concat("water", str(M, 0, 0), ".inc")
        translate Shift*M
    }
#end
