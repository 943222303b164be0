using System.Collections.Concurrent;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Light paths under way, as a structure of arrays: entry i of every column belongs to path i. A stage reads one stream and
/// writes the paths that have a next ray to another.
/// </summary>
public sealed unsafe class PathStream
{
    private const int Columns = 32;

    // What nobody uses. The moving view follows paths thirty times a second, and memory for each time would be collected as often.
    private static readonly ConcurrentBag<PathStream> s_free = [];
    private static readonly int s_most = 8 * Environment.ProcessorCount;
    private readonly PinnedBuffer<float> _memory;
    private readonly PinnedBuffer<RayW> _packet = new(1);

    /// <summary>Makes an empty stream.</summary>
    /// <param name="capacity">The number of paths that it can hold.</param>
    internal PathStream(int capacity)
    {
        // Room for a whole register behind the last path, and columns that do not all start on the same cache set.
        int stride = (capacity + (2 * 16) + 15) / 16 * 16 + 16;
        _memory = new((long)stride * Columns);
        float* column = _memory.Pointer;
        float* Next()
        {
            float* taken = column;
            column += stride;
            return taken;
        }

        Capacity = capacity;
        OriginX = Next();
        OriginY = Next();
        OriginZ = Next();
        DirectionX = Next();
        DirectionY = Next();
        DirectionZ = Next();
        ThroughputR = Next();
        ThroughputG = Next();
        ThroughputB = Next();
        RadianceR = Next();
        RadianceG = Next();
        RadianceB = Next();
        Distance = Next();
        Primitive = (uint*)Next();
        Path = (uint*)Next();
        State = (uint*)Next();
        Instance = (uint*)Next();
        Time = Next();
        Pdf = Next();
        Media = (uint*)Next();
        Travelled = Next();
        NormalX = Next();
        NormalY = Next();
        NormalZ = Next();
        StartInstance = (uint*)Next();
        InnerX = Next();
        InnerY = Next();
        InnerZ = Next();
        Vcm = Next();
        Vc = Next();
        Vm = Next();
        Passed = Next();
    }

    /// <summary>Takes an empty stream, to be given back; what its columns hold is whatever was in them last.</summary>
    /// <param name="capacity">The number of paths that it can hold.</param>
    internal static PathStream Take(int capacity)
    {
        if (!s_free.TryTake(out PathStream? stream) || stream.Capacity != capacity)
        {
            return new(capacity);
        }

        stream.Count = 0;
        return stream;
    }

    /// <summary>Gives it back; the caller uses it no more.</summary>
    internal void GiveBack()
    {
        if (s_free.Count < s_most)
        {
            s_free.Add(this);
        }
    }

    internal int Capacity { get; }

    /// <summary>Room for a packet of the rays.</summary>
    internal ref RayW Packet => ref *_packet.Pointer;

    /// <summary>Number of paths in the stream.</summary>
    public int Count { get; internal set; }

    // Where the next ray starts, its unit direction, what it will find is multiplied by, and what the path has gathered.
    internal float* OriginX { get; }
    internal float* OriginY { get; }
    internal float* OriginZ { get; }
    internal float* DirectionX { get; }
    internal float* DirectionY { get; }
    internal float* DirectionZ { get; }
    internal float* ThroughputR { get; }
    internal float* ThroughputG { get; }
    internal float* ThroughputB { get; }
    internal float* RadianceR { get; }
    internal float* RadianceG { get; }
    internal float* RadianceB { get; }

    /// <summary>The distance of what the ray met.</summary>
    public float* Distance { get; }
    internal uint* Primitive { get; }

    /// <summary>The instance that showed the primitive, 0 for the world itself; set only where there are instances.</summary>
    internal uint* Instance { get; }

    /// <summary>The path's time in seconds; set only where something moves.</summary>
    public float* Time { get; }

    /// <summary>
    /// The density, per steradian, with which the ray's direction was chosen; set only where a light may be met that was sampled too.
    /// </summary>
    internal float* Pdf { get; }

    /// <summary>The media that the path is in (<see cref="Media.MediumStack"/>); set only where there are media.</summary>
    internal uint* Media { get; }

    /// <summary>The distance that the path has gone through boundaries since it last scattered; set only where there are media.</summary>
    internal float* Travelled { get; }

    // The normal of the surface where the ray starts, by which lights were chosen there; zero where all directions counted. Set only where one light of
    // many is chosen.
    internal float* NormalX { get; }
    internal float* NormalY { get; }
    internal float* NormalZ { get; }

    /// <summary>The instance from whose surface the ray starts; 0 for none.</summary>
    internal uint* StartInstance { get; }

    // Where that is in the instance's space: its own things are near there, however far away it stands in the world.
    internal float* InnerX { get; }
    internal float* InnerY { get; }
    internal float* InnerZ { get; }

    // The partial sums of the other ways to make the path (SubpathSumsW); set only where subpaths are connected.
    internal float* Vcm { get; }
    internal float* Vc { get; }
    internal float* Vm { get; }

    /// <summary>
    /// The mean probability with which media let through what has come so far since the path last scattered; set only where subpaths are connected and
    /// there are media.
    /// </summary>
    internal float* Passed { get; }

    /// <summary>Number of the path in the tile: pixel · samples + sample.</summary>
    public uint* Path { get; }

    /// <summary>See <see cref="PathState"/>.</summary>
    public uint* State { get; }

    /// <summary>Adds the chosen lanes of a packet at the end.</summary>
    public void Append(uint lanes, in Vec3W origin, in Vec3W direction, in RgbW throughput, in RgbW radiance, in UIntW path, in UIntW state)
    {
        int at = Count;
        origin.X.Compress(OriginX + at, lanes);
        origin.Y.Compress(OriginY + at, lanes);
        origin.Z.Compress(OriginZ + at, lanes);
        direction.X.Compress(DirectionX + at, lanes);
        direction.Y.Compress(DirectionY + at, lanes);
        direction.Z.Compress(DirectionZ + at, lanes);
        throughput.R.Compress(ThroughputR + at, lanes);
        throughput.G.Compress(ThroughputG + at, lanes);
        throughput.B.Compress(ThroughputB + at, lanes);
        radiance.R.Compress(RadianceR + at, lanes);
        radiance.G.Compress(RadianceG + at, lanes);
        radiance.B.Compress(RadianceB + at, lanes);
        path.Compress(Path + at, lanes);
        state.Compress(State + at, lanes);
        ((UIntW)0u).Store(StartInstance + at);
        Count = at + System.Numerics.BitOperations.PopCount(lanes);
    }

    /// <summary>The paths' rays, with their distances, as a tree takes them.</summary>
    /// <param name="hits">Takes what they hit.</param>
    internal RayStream Rays(int* hits) => new()
    {
        OriginX = OriginX,
        OriginY = OriginY,
        OriginZ = OriginZ,
        DirectionX = DirectionX,
        DirectionY = DirectionY,
        DirectionZ = DirectionZ,
        Distance = Distance,
        Primitive = hits,
        Count = Count,
    };

    /// <summary>The ray of one path.</summary>
    internal SpaceRay Ray(int path) =>
        new(new(OriginX[path], OriginY[path], OriginZ[path]), new(DirectionX[path], DirectionY[path], DirectionZ[path]))
        {
            StartInstance = (int)StartInstance[path],
            InnerStart = new(InnerX[path], InnerY[path], InnerZ[path]),
        };

    /// <summary>Sets the times of the chosen lanes of a packet that is appended next.</summary>
    public void SetTime(uint lanes, in FloatW time) => time.Compress(Time + Count, lanes);

    /// <summary>Sets the densities of the chosen lanes of a packet that is appended next.</summary>
    internal void SetPdf(uint lanes, in FloatW pdf) => pdf.Compress(Pdf + Count, lanes);

    /// <summary>Sets the media of the chosen lanes of a packet that is appended next, and how far they have gone through them.</summary>
    internal void SetMedia(uint lanes, in UIntW media, in FloatW travelled)
    {
        media.Compress(Media + Count, lanes);
        travelled.Compress(Travelled + Count, lanes);
    }

    /// <summary>Sets the normals of the chosen lanes of a packet that is appended next.</summary>
    internal void SetNormal(uint lanes, in Vec3W normal)
    {
        normal.X.Compress(NormalX + Count, lanes);
        normal.Y.Compress(NormalY + Count, lanes);
        normal.Z.Compress(NormalZ + Count, lanes);
    }

    /// <summary>Sets the partial sums of the chosen lanes of a packet that is appended next.</summary>
    internal void SetSums(uint lanes, in SubpathSumsW sums)
    {
        sums.Vcm.Compress(Vcm + Count, lanes);
        sums.Vc.Compress(Vc + Count, lanes);
        sums.Vm.Compress(Vm + Count, lanes);
    }

    /// <summary>Sets how likely the chosen lanes of a packet that is appended next have come so far.</summary>
    internal void SetPassed(uint lanes, in FloatW passed) => passed.Compress(Passed + Count, lanes);

    /// <summary>Says in which instances' spaces the chosen lanes of the packet start that was appended last, and where there.</summary>
    internal void SetStart(uint lanes, in UIntW instance, in Vec3W start)
    {
        int at = Count - System.Numerics.BitOperations.PopCount(lanes);
        instance.Compress(StartInstance + at, lanes);
        start.X.Compress(InnerX + at, lanes);
        start.Y.Compress(InnerY + at, lanes);
        start.Z.Compress(InnerZ + at, lanes);
    }

    /// <summary>Where the paths of a packet start in their instances' spaces.</summary>
    internal Vec3W PickInnerStart(uint* index) => new(FloatW.Pick(InnerX, index), FloatW.Pick(InnerY, index), FloatW.Pick(InnerZ, index));

    /// <summary>Normals where the paths of a packet start.</summary>
    internal Vec3W PickNormal(uint* index) => new(FloatW.Pick(NormalX, index), FloatW.Pick(NormalY, index), FloatW.Pick(NormalZ, index));

    /// <summary>Radiance gathered by the paths of a packet.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RgbW PickRadiance(uint* index) =>
        new(FloatW.Pick(RadianceR, index), FloatW.Pick(RadianceG, index), FloatW.Pick(RadianceB, index));

    /// <summary>Throughput of the paths of a packet.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RgbW PickThroughput(uint* index) =>
        new(FloatW.Pick(ThroughputR, index), FloatW.Pick(ThroughputG, index), FloatW.Pick(ThroughputB, index));

    /// <summary>Directions of the paths of a packet.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vec3W PickDirection(uint* index) =>
        new(FloatW.Pick(DirectionX, index), FloatW.Pick(DirectionY, index), FloatW.Pick(DirectionZ, index));

    /// <summary>Origins of the paths of a packet.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vec3W PickOrigin(uint* index) =>
        new(FloatW.Pick(OriginX, index), FloatW.Pick(OriginY, index), FloatW.Pick(OriginZ, index));
}

/// <summary>A packet of rays, and what they met.</summary>
internal struct RayW
{
    public Vec3W Origin;
    public Vec3W Direction;
    public FloatW Distance;
    public UIntW Primitive;
}

/// <summary>The state of a path besides its numbers, in one integer.</summary>
public static class PathState
{
    /// <summary>Bits 0–7 count diffuse bounces.</summary>
    public const uint OneDiffuse = 1;

    /// <summary>Bits 8–15 count specular bounces.</summary>
    public const uint OneSpecular = 1 << 8;

    /// <summary>A depth's bits, once it is shifted down.</summary>
    public const uint DepthMask = 0xff;

    /// <summary>The number of bits by which the specular depth is shifted up.</summary>
    public const int SpecularShift = 8;

    /// <summary>Emission at the next hit counts: the last scattering was specular, or there was none (report: countEmittedLight).</summary>
    public const uint CountsEmission = 1 << 16;

    /// <summary>Where subpaths are connected, the lowest bits are the number of the vertex instead, from 0.</summary>
    internal const uint VertexMask = 0xffff;

    /// <summary>
    /// The path has met a dispersing surface: it stands for light of a single wavelength from there on, and its throughput has that
    /// wavelength's colour.
    /// </summary>
    public const uint HasWavelength = 1 << 17;

    /// <summary>A surface has scattered the path into one direction of many; set only where subpaths are connected.</summary>
    internal const uint HasScattered = 1 << 19;

    /// <summary>Of a light path's vertex that is kept: it lies in a medium.</summary>
    internal const uint IsInMedium = 1 << 20;

    /// <summary>Bits 21–31 count the surfaces that a path went straight through and that are no bounce (<see cref="Scene.CountsPassed"/>).</summary>
    internal const uint OnePassed = 1 << PassedShift;

    /// <summary>The number of bits by which that count is shifted up.</summary>
    internal const int PassedShift = 21;

    /// <summary>The bits of that count.</summary>
    internal const uint PassedMask = uint.MaxValue << PassedShift;
}
