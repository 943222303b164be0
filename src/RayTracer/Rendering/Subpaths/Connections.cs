using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Connects vertices of camera paths with the vertices of a light path. The camera's end is computed where the camera path is; then connections wait,
/// are sorted by what the light's end is on, and that end is described again and computed, so that both are shaded in packets.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="pass">Has the light paths.</param>
/// <param name="gather">Takes the light for the camera's paths where rays are traced through media at once.</param>
/// <param name="recorder">Records what they bring; may be null.</param>
internal sealed unsafe class Connections(Scene scene, LightPass pass, Gathering gather, StrategyRecorder? recorder)
{
    private const int Full = 16384;
    private readonly Transmittance? _transmittance = scene.TracksInteriors ? new(scene) : null;
    private Connection[] _waiting = new Connection[Full];

    // For those who look at paths: the throughput, the BSDF and the cosine at the camera's ends.
    private readonly List<(Rgb Throughput, Rgb Bsdf, float Cosine)> _ends = [];
    private int[] _order = new int[Full];
    private readonly int[] _starts = new int[scene.Groups.Length + 3];
    private readonly PathStream _room = new(16);
    private readonly PinnedBuffer<uint> _iota = Iota();
    private readonly PinnedBuffer<EndW> _end = new(1);
    private int _count;

    /// <summary>So many wait that they should be traced.</summary>
    public bool IsFull => _count >= Full;

    /// <summary>The number of rays that were asked for.</summary>
    public long Traced { get; private set; }

    /// <summary>Connects vertices with all vertices of a light path each.</summary>
    /// <param name="group">The group of surfaces.</param>
    /// <param name="surface">The vertices of camera paths.</param>
    /// <param name="camera">More of them.</param>
    /// <param name="lightPath">Numbers of the light paths.</param>
    /// <param name="maxDepth">The number of edges that a whole path may have.</param>
    /// <param name="active">The lanes in use.</param>
    public void Add(ShadingGroup group, ref SurfaceW surface, in CameraEndW camera, UIntW lightPath, uint maxDepth, MaskW active)
    {
        lightPath = active.Select(lightPath, 0u);
        UIntW next = UIntW.Gather(pass.Vertices.First, lightPath);
        UIntW end = active.Select(UIntW.Gather(pass.Vertices.First + 1, lightPath), 0u);
        for (MaskW has = active & next < end; has.Any; has = active & next < end)
        {
            // The vertices of a path come by their numbers: those after one too many are, too.
            UIntW vertex = has.Select(next, 0u);
            UIntW at = vertex * LightVertex.Numbers;
            float* numbers = (float*)pass.Vertices.Vertices;
            UIntW number = UIntW.Gather((uint*)numbers + 12, at) & PathState.VertexMask;
            has &= camera.Number + number + 2u < maxDepth;
            Vec3W to = Vec3W.Gather(numbers, at) - surface.Point;
            FloatW distance2 = Vec3W.Dot(to, to);
            Vec3W direction = to * (1f / FloatW.Sqrt(distance2));
            Wait(group, ref surface, camera, vertex, direction, has & distance2 > 0f);
            next += 1u;
        }
    }

    /// <summary>Computes all that wait.</summary>
    /// <param name="rays">Takes the rays between the ends, with what they bring, for the camera's paths.</param>
    /// <param name="trace">Makes room for rays.</param>
    public void Flush(ShadowRays rays, Action trace)
    {
        Sort();
        for (int i = 0; i < _count;)
        {
            int group = GroupOf(_order[i]);
            int count = 1;
            while (count < FloatW.Count && i + count < _count && GroupOf(_order[i + count]) == group)
            {
                count++;
            }

            if (!rays.HasRoomFor(FloatW.Count))
            {
                trace();
            }

            Connect(group > scene.Groups.Length ? scene.GroupOfMedia : scene.Groups[group], _order.AsSpan(i, count), rays);
            i += count;
        }

        _count = 0;
        _ends.Clear();
    }

    private static PinnedBuffer<uint> Iota()
    {
        PinnedBuffer<uint> numbers = new(16);
        for (uint i = 0; i < 16; i++)
        {
            numbers.Pointer[i] = i;
        }

        return numbers;
    }

    private int GroupOf(int connection) => scene.GroupOfPrimitive[pass.Vertices.Vertices[_waiting[connection].Vertex].Primitive];

    // By the group of the light's end; those of one group as they came.
    private void Sort()
    {
        if (_order.Length < _count)
        {
            _order = new int[_waiting.Length];
        }

        Array.Clear(_starts);
        for (int i = 0; i < _count; i++)
        {
            _starts[GroupOf(i) + 1]++;
        }

        for (int group = 1; group < _starts.Length; group++)
        {
            _starts[group] += _starts[group - 1];
        }

        for (int i = 0; i < _count; i++)
        {
            _order[_starts[GroupOf(i)]++] = i;
        }
    }

    // The camera's end.
    private void Wait(ShadingGroup group, ref SurfaceW surface, in CameraEndW camera, UIntW vertex, in Vec3W direction, MaskW active)
    {
        if (!active.Any)
        {
            return;
        }

        group.Material.Evaluate(surface, direction, out RgbW bsdf, out FloatW pdf);
        active = active.Except((bsdf.R <= 0f) & (bsdf.G <= 0f) & (bsdf.B <= 0f)).Except(SurfaceShader.Dropped(surface, direction));
        if (!active.Any)
        {
            return;
        }

        Adjoint.ReversePdf(group.Material, ref surface, direction, out FloatW reversePdf);
        RgbW value = camera.Throughput * bsdf * (InteriorShader.Cosine(surface, direction) * pass.Weights.PerLightPath);
        FloatW sum = camera.Sums.Connected(reversePdf, pass.Weights.At(group));
        FloatW cosine = InteriorShader.Meeting(surface, direction);
        UIntW media = 0u;
        if (scene.TracksInteriors)
        {
            SurfaceShader.MediaAlong(scene, surface, direction, group.Interior, camera.Media, out media);
        }

        Vec3W start = SurfaceShader.Leave(surface, direction);
        Vec3W inner = group.IsInstanced ? SurfaceShader.LeaveInside(surface, direction) : default;
        for (uint lanes = active.Bits; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            if (recorder is not null)
            {
                _ends.Add((Lane(camera.Throughput, lane), Lane(bsdf, lane), InteriorShader.Cosine(surface, direction)[lane]));
            }

            if (_count == _waiting.Length)
            {
                Array.Resize(ref _waiting, 2 * _count);
            }

            _waiting[_count++] = new()
            {
                Start = new(start.X[lane], start.Y[lane], start.Z[lane]),
                Direction = new(direction.X[lane], direction.Y[lane], direction.Z[lane]),
                Value = new(value.R[lane], value.G[lane], value.B[lane]),
                Color = new(camera.Color.R[lane], camera.Color.G[lane], camera.Color.B[lane]),
                Sum = sum[lane],
                Pdf = pdf[lane],
                Cosine = cosine[lane],
                Time = camera.Time[lane],
                Instance = group.IsInstanced ? surface.Instance[lane] : 0,
                Inner = new(inner.X[lane], inner.Y[lane], inner.Z[lane]),
                Path = camera.Path[lane],
                Vertex = vertex[lane],
                Number = camera.Number[lane],
                Media = media[lane],
            };
        }
    }

    // The light's end.
    private void Connect(ShadingGroup group, ReadOnlySpan<int> chosen, ShadowRays rays)
    {
        ref EndW end = ref *_end.Pointer;
        Load(chosen, ref end);
        SubpathShader.DescribeVertex(scene, group, _room, _iota.Pointer, out end.Surface);
        ref SurfaceW surface = ref end.Surface;
        surface.Wavelength = group.Traits.Disperses ? end.Wavelength : surface.Wavelength;
        if (scene.HasNesting && group.IsNested)
        {
            scene.Media.Index(InteriorShader.Around(scene, group, surface, UIntW.Load(_room.Media)), surface.Wavelength, out surface.ExteriorIndex);
        }

        MaskW active = MaskW.First(chosen.Length);
        Vec3W direction = -end.Direction;
        surface.CarriesLight = true;
        group.Material.Pdf(surface, direction, out FloatW pdf);
        Adjoint.Evaluate(group.Material, ref surface, direction, out RgbW scattered, out FloatW reversePdf);
        Vec3W goal = SurfaceShader.Leave(surface, direction);
        Vec3W to = goal - end.Start;
        FloatW distance2 = Vec3W.Dot(to, to);
        FloatW distance = FloatW.Sqrt(distance2);
        FloatW cosine = InteriorShader.Meeting(surface, direction);
        FloatW lit = PathWeights.Power(end.Pdf * cosine / distance2) * end.Sums.Connected(reversePdf, pass.Weights.At(group));
        FloatW seen = PathWeights.Power(pdf * end.Cosine / distance2) * end.Sum;
        active = active.Except((scattered.R <= 0f) & (scattered.G <= 0f) & (scattered.B <= 0f)) & distance2 > 0f;
        Vec3W towards = to * (1f / distance);
        Traced += BitOperations.PopCount(active.Bits);
        if (_transmittance is not null)
        {
            _transmittance.Trace(active.Bits, end.Start, end.Instance, end.Inner, towards, distance, end.Media, end.Time, null, out RgbW left, out FloatW passed);
            FloatW others = (lit + seen) * PathWeights.Power(passed);
            RgbW arriving = end.Value * end.Power * scattered * left * (1f / (distance2 * (others + 1f)));
            gather(active.Bits, end.Path, arriving);
            if (recorder is not null)
            {
                recorder.Add(active.Bits, end.Path, Ways(chosen, end, scattered, distance2, left), arriving, arriving * (others + 1f));
            }

            return;
        }

        FloatW scale = 1f / (distance2 * (lit + seen + 1f));
        RgbW light = end.Value * end.Power * scattered * scale;
        scene.Primitives.Occlude(end.Start, towards, distance, -1, ref active);
        if (active.Any)
        {
            rays.Add(active.Bits, end.Start, end.Instance, end.Inner, towards, distance, end.Time, -1, light, 0f, end.Path);
            if (recorder is not null)
            {
                recorder.Wait(active.Bits, Ways(chosen, end, scattered, distance2, Rgb.White), light * (lit + seen + 1f));
            }
        }
    }

    private static Rgb Lane(in RgbW color, int lane) => new(color.R[lane], color.G[lane], color.B[lane]);

    private WaysW Ways(ReadOnlySpan<int> chosen, in EndW end, in RgbW scattered, in FloatW distance2, in RgbW left)
    {
        uint* numbers = stackalloc uint[3 * FloatW.Count];
        float* ends = stackalloc float[7 * FloatW.Count];
        for (int lane = 0; lane < chosen.Length; lane++)
        {
            ref Connection connection = ref _waiting[chosen[lane]];
            ref LightVertex vertex = ref pass.Vertices.Vertices[connection.Vertex];
            numbers[lane] = (vertex.State & PathState.VertexMask) + 2;
            numbers[FloatW.Count + lane] = connection.Number + 2;
            numbers[(2 * FloatW.Count) + lane] = vertex.Path;
            (Rgb throughput, Rgb bsdf, float cosine) = _ends[chosen[lane]];
            Rgb color = (vertex.State & PathState.HasWavelength) != 0 ? connection.Color : Rgb.White;
            ReadOnlySpan<float> values = [throughput.R * color.R, throughput.G * color.G, throughput.B * color.B, bsdf.R, bsdf.G, bsdf.B, cosine];
            for (int i = 0; i < values.Length; i++)
            {
                ends[(i * FloatW.Count) + lane] = values[i];
            }
        }

        FloatW cosines = Adjoint.Cosines(end.Surface, -end.Direction);
        WayFactorsW factors = new()
        {
            CameraPart = Color(ends, 0),
            CameraBsdf = Color(ends, 3),
            LightPart = end.Power,
            LightBsdf = scattered * (1f / cosines),
            Left = left,
            Geometry = FloatW.Load(ends + (6 * FloatW.Count)) * cosines / distance2,
            Paths = pass.Weights.PerLightPath,
        };
        return new() { Factors = factors, From = UIntW.Load(numbers), To = UIntW.Load(numbers + FloatW.Count), LightPath = UIntW.Load(numbers + (2 * FloatW.Count)), Point = end.Surface.Point };

        static RgbW Color(float* values, int first) => new(FloatW.Load(values + (first * FloatW.Count)), FloatW.Load(values + ((first + 1) * FloatW.Count)), FloatW.Load(values + ((first + 2) * FloatW.Count)));
    }

    // Brings the connections of a packet, and the rays that met the light's vertices, into lanes.
    private void Load(ReadOnlySpan<int> chosen, ref EndW end)
    {
        float* numbers = (float*)_end.Pointer;
        _room.Count = FloatW.Count;
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            ref Connection connection = ref _waiting[chosen[Math.Min(lane, chosen.Length - 1)]];
            ref LightVertex vertex = ref pass.Vertices.Vertices[connection.Vertex];
            vertex.Put(_room, lane, connection.Time);
            Rgb color = (vertex.State & PathState.HasWavelength) != 0 ? connection.Color : Rgb.White;
            ReadOnlySpan<float> values =
            [
                connection.Start.X, connection.Start.Y, connection.Start.Z, connection.Direction.X, connection.Direction.Y, connection.Direction.Z,
                connection.Value.R * color.R, connection.Value.G * color.G, connection.Value.B * color.B, connection.Sum, connection.Pdf, connection.Cosine,
                connection.Time, connection.Inner.X, connection.Inner.Y, connection.Inner.Z, vertex.Power.R, vertex.Power.G, vertex.Power.B,
                vertex.Vcm, vertex.Vc, vertex.Vm, vertex.Wavelength, BitConverter.UInt32BitsToSingle(connection.Instance), BitConverter.UInt32BitsToSingle(connection.Path),
                BitConverter.UInt32BitsToSingle(connection.Media),
            ];
            for (int i = 0; i < values.Length; i++)
            {
                numbers[(i * FloatW.Count) + lane] = values[i];
            }
        }
    }

    private struct Connection
    {
        public Vector3 Start, Direction, Inner;
        public Rgb Value, Color;
        public float Sum, Pdf, Cosine, Time;
        public uint Instance, Path, Vertex, Number, Media;
    }

    // In the order of Load.
    private struct EndW
    {
        public Vec3W Start, Direction;
        public RgbW Value;
        public FloatW Sum, Pdf, Cosine, Time;
        public Vec3W Inner;
        public RgbW Power;
        public SubpathSumsW Sums;
        public FloatW Wavelength;
        public UIntW Instance, Path, Media;
        public SurfaceW Surface;
    }
}

/// <summary>Takes light for paths.</summary>
/// <param name="lanes">The lanes in use.</param>
/// <param name="path">The paths' numbers.</param>
/// <param name="light">The light.</param>
internal delegate void Gathering(uint lanes, in UIntW path, in RgbW light);
