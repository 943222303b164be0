using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>A vertex of a light path: the ray that met it, by which its surface is described again, and what arrives along that.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 4)]
internal unsafe struct LightVertex
{
    /// <summary>Its size in numbers of 32 bits.</summary>
    public const uint Numbers = 26;

    /// <summary>Where it is.</summary>
    public Vector3 Point;

    /// <summary>Unit direction of the ray, along which the light travels.</summary>
    public Vector3 Direction;

    /// <summary>The light's power; without the colour of its wavelength, if it has one.</summary>
    public Rgb Power;

    /// <summary>The partial sums (<see cref="SubpathSumsW"/>).</summary>
    public float Vcm, Vc, Vm;

    /// <summary>Number of the vertex on its path, from 0, and the state's bits.</summary>
    public uint State;

    /// <summary>Number of the path in the pass.</summary>
    public uint Path;

    /// <summary>The start of the ray.</summary>
    public Vector3 Origin;

    /// <summary>The length of the ray.</summary>
    public float Distance;

    /// <summary>What was met.</summary>
    public uint Primitive, Instance;

    /// <summary>The instance on which the ray starts, and where in its space.</summary>
    public uint StartInstance;

    /// <summary>Where it starts there.</summary>
    public Vector3 InnerStart;

    /// <summary>The path's wavelength in µm where the surface disperses light; else of no meaning.</summary>
    public float Wavelength;

    /// <summary>The media through which the ray came at last; set only where paths track them.</summary>
    public uint Media;

    /// <summary>Writes the ray that met it, with its hit, into a stream.</summary>
    /// <param name="stream">The stream.</param>
    /// <param name="i">Where.</param>
    /// <param name="time">The time in seconds; used only where something moves.</param>
    public readonly void Put(PathStream stream, int i, float time)
    {
        (stream.OriginX[i], stream.OriginY[i], stream.OriginZ[i]) = (Origin.X, Origin.Y, Origin.Z);
        (stream.DirectionX[i], stream.DirectionY[i], stream.DirectionZ[i]) = (Direction.X, Direction.Y, Direction.Z);
        (stream.Distance[i], stream.Time[i]) = (Distance, time);
        (stream.Primitive[i], stream.Instance[i], stream.StartInstance[i]) = (Primitive, Instance, StartInstance);
        stream.Media[i] = Media;
        (stream.InnerX[i], stream.InnerY[i], stream.InnerZ[i]) = (InnerStart.X, InnerStart.Y, InnerStart.Z);
    }
}
