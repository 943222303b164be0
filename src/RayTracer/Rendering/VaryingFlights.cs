using System.Numerics;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Paths on their way through a medium that varies.</summary>
internal struct TrackW
{
    /// <summary>Where they are.</summary>
    public FlightW Flight;

    /// <summary>The number that decides what happens at the next place.</summary>
    public FloatW Choice;

    /// <summary>What they carry.</summary>
    public RgbW Throughput;

    /// <summary>Their indices in the stream.</summary>
    public UIntW Path;

    /// <summary>1; 0 in lanes without a path.</summary>
    public FloatW Busy;
}

/// <summary>
/// Chooses where media that vary scatter paths, by delta tracking (Woodcock et al. 1965): at each place that a ray comes to, it is scattered with the probability of the extinction
/// there over the majorant. Where channels differ, that probability is their mean, each by what the path still carries of it, and what it carries is multiplied by what was
/// likely over what was done: the sum over the channels never grows (the history-aware probabilities of Kutz et al. 2017, which are
/// the balance heuristic of Miller, Georgiev &amp; Jarosz 2019 for a single path). A medium that scatters nothing takes its part of the light at each place instead (ratio
/// tracking). A lane whose path is done takes the next path: long ways make no other wait.
/// </summary>
internal sealed unsafe class VaryingFlights
{
    private readonly PinnedBuffer<TrackW> _track = new(1);
    private PinnedBuffer<float> _waiting = new(0);
    private int _room;
    private int _count;

    private static int Registers => sizeof(TrackW) / sizeof(FloatW);

    /// <summary>Adds paths that wait.</summary>
    public void Add(in TrackW tracks, in MaskW among)
    {
        uint bits = among.Bits;
        if (_count + (2 * FloatW.Count) > _room)
        {
            Grow();
        }

        fixed (TrackW* from = &tracks)
        {
            for (int i = 0; i < Registers; i++)
            {
                FloatW.Load((float*)from + (i * FloatW.Count)).Compress(_waiting.Pointer + ((long)i * _room) + _count, bits);
            }
        }

        _count += BitOperations.PopCount(bits);
    }

    /// <summary>Follows the paths that wait, to where they are scattered or to what they meet.</summary>
    /// <param name="medium">The medium that all are in.</param>
    /// <param name="stream">Their stream.</param>
    /// <param name="scattered">The number of the primitive that stands for scattering.</param>
    /// <param name="observer">Sees the light that the medium sends; null for nobody.</param>
    public void Track(VaryingMedium medium, PathStream stream, uint scattered, PathObserver? observer)
    {
        ref TrackW track = ref *_track.Pointer;
        track = default;
        int next = 0;
        int started = int.Min(_count, FloatW.Count);
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            // Lanes that are not needed repeat a path, and are not busy.
            Load(lane, int.Min(next, _count - 1));
            if (next++ >= started)
            {
                track.Busy = MaskW.First(started).Select(1f, 0f);
            }
        }

        next = started;
        for (MaskW busy = track.Busy > 0f; busy.Any; busy = track.Busy > 0f)
        {
            MaskW arrived = track.Flight.Seek(medium, busy, aboveBase: false);
            if (medium.Emits)
            {
                // At each place as much as, on average, the way between two of them.
                medium.Emission(track.Flight.Place(), out RgbW emission);
                RgbW light = track.Throughput * emission * (1f / track.Flight.Rate);
                Shine(light, arrived, track.Path, stream, observer);
            }

            MaskW hit = arrived.Any ? Happen(medium, ref track, arrived) : MaskW.None;
            for (uint done = (busy.Except(arrived) | hit).Bits; done != 0; done &= done - 1)
            {
                int lane = BitOperations.TrailingZeroCount(done);
                Finish(lane, stream, (hit.Bits >> lane & 1) != 0, scattered);
                if (next < _count)
                {
                    Load(lane, next++);
                }
                else
                {
                    ((float*)&_track.Pointer->Busy)[lane] = 0;
                }
            }
        }

        _count = 0;
    }

    /// <summary>Adds light that media send to what paths have gathered.</summary>
    /// <param name="light">The light.</param>
    /// <param name="among">The paths.</param>
    /// <param name="index">Their indices in the stream.</param>
    /// <param name="stream">Their stream.</param>
    /// <param name="observer">Sees the light; null for nobody.</param>
    public static void Shine(in RgbW light, in MaskW among, in UIntW index, PathStream stream, PathObserver? observer)
    {
        for (uint rest = (among & (light.R + light.G + light.B > 0f)).Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            uint path = index[lane];
            Rgb here = new(light.R[lane], light.G[lane], light.B[lane]);
            stream.RadianceR[path] += here.R;
            stream.RadianceG[path] += here.G;
            stream.RadianceB[path] += here.B;
            observer?.Shone(stream.Path[path], here);
        }
    }

    // What happens where rays have come to: they are scattered, or go on.
    private static MaskW Happen(VaryingMedium medium, ref TrackW track, in MaskW arrived)
    {
        Vec3W place = track.Flight.Place();
        medium.Extinction(place, track.Flight.Direction, out RgbW extinction);
        FloatW inverse = 1f / track.Flight.Rate;
        RgbW part = new(FloatW.Min(extinction.R * inverse, 1f), FloatW.Min(extinction.G * inverse, 1f), FloatW.Min(extinction.B * inverse, 1f));
        MaskW hit = MaskW.None;
        if (!medium.Scatters)
        {
            track.Throughput *= arrived.Select(new RgbW(1f - part.R, 1f - part.G, 1f - part.B), Rgb.White);
        }
        else if (medium.IsGrey)
        {
            hit = arrived & (track.Choice < part.R);
        }
        else
        {
            RgbW carried = track.Throughput;
            FloatW all = FloatW.Max(carried.R + carried.G + carried.B, float.Epsilon);
            FloatW chance = FloatW.MultiplyAdd(carried.R, part.R, FloatW.MultiplyAdd(carried.G, part.G, carried.B * part.B)) / all;
            hit = arrived & (track.Choice < chance);
            FloatW other = 1f - chance;
            RgbW gone = part * (1f / chance);
            RgbW left = new((1f - part.R) / other, (1f - part.G) / other, (1f - part.B) / other);
            track.Throughput *= arrived.Select(hit.Select(gone, left), Rgb.White);
        }

        if (hit.Any)
        {
            medium.Albedo(place, out RgbW albedo);
            track.Throughput *= hit.Select(albedo, Rgb.White);
        }

        track.Choice = arrived.Select(track.Flight.Draw(arrived), track.Choice);
        track.Flight.Depth = arrived.Select(FlightW.DepthOf(track.Flight.Draw(arrived)), track.Flight.Depth);
        return hit;
    }

    private void Finish(int lane, PathStream stream, bool isScattered, uint scattered)
    {
        TrackW* track = _track.Pointer;
        uint path = ((uint*)&track->Path)[lane];
        float* throughput = (float*)&track->Throughput;
        stream.ThroughputR[path] = throughput[lane];
        stream.ThroughputG[path] = throughput[FloatW.Count + lane];
        stream.ThroughputB[path] = throughput[(2 * FloatW.Count) + lane];
        if (isScattered)
        {
            stream.Distance[path] = ((float*)&track->Flight.Before)[lane] + ((float*)&track->Flight.At)[lane];
            stream.Primitive[path] = scattered;
        }
    }

    private void Load(int lane, int path)
    {
        float* to = (float*)_track.Pointer + lane;
        float* from = _waiting.Pointer + path;
        for (int i = 0; i < Registers; i++)
        {
            to[i * FloatW.Count] = from[(long)i * _room];
        }
    }

    private void Grow()
    {
        int room = int.Max(1024, 2 * _room);
        PinnedBuffer<float> larger = new((long)room * Registers);
        for (int i = 0; i < Registers; i++)
        {
            new Span<float>(_waiting.Pointer + ((long)i * _room), _count).CopyTo(new Span<float>(larger.Pointer + ((long)i * room), _count));
        }

        (_waiting, _room) = (larger, room);
    }
}
