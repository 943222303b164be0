using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>
/// What media that vary leave of the light along shadow rays, by residual ratio tracking (Novák, Selle &amp; Jarosz 2014): the least extinction in each cell weakens it by Beer's law,
/// and the rest takes its part at each place that the ray comes to.
/// </summary>
internal sealed unsafe class ShadowFlights
{
    // Rays with less light than this end at random, and the others make up for them.
    private const float Little = 0.1f;
    private readonly PinnedBuffer<FlightW> _flight = new(1);
    private readonly PinnedBuffer<uint> _keys = new(16);

    /// <summary>Sets the keys of the rays' random numbers.</summary>
    public void Begin(in UIntW keys) => keys.Store(_keys.Pointer);

    /// <summary>Weakens the light of a packet of rays.</summary>
    /// <param name="media">The scene's media.</param>
    /// <param name="rays">The rays; their paths are the numbers of their keys.</param>
    /// <param name="stack">The media that they are in.</param>
    /// <param name="way">How far they go.</param>
    /// <param name="boundary">How many boundaries they have crossed.</param>
    /// <param name="left">The light that is left.</param>
    public void Weaken(MediumTable media, PathStream rays, in UIntW stack, in FloatW way, uint boundary, ref RgbW left)
    {
        foreach ((uint number, VaryingMedium medium) in media.Varying)
        {
            MaskW inside = MaskW.First(rays.Count) & UIntW.Equal(MediumStack.Innermost(stack), number);
            if (!inside.Any)
            {
                continue;
            }

            ref FlightW flight = ref *_flight.Pointer;
            Vec3W origin = new(FloatW.Load(rays.OriginX), FloatW.Load(rays.OriginY), FloatW.Load(rays.OriginZ));
            Vec3W direction = new(FloatW.Load(rays.DirectionX), FloatW.Load(rays.DirectionY), FloatW.Load(rays.DirectionZ));
            MaskW meets = inside & flight.Begin(medium, origin, direction, way);
            UIntW lane = MaskW.First(rays.Count).Select(UIntW.Load(rays.Path), 0u);
            flight.Key = Hash.Mix(UIntW.Gather(_keys.Pointer, lane) + ((boundary + 1) * Hash.Golden));
            flight.Drawn = 0u;
            flight.Depth = FlightW.DepthOf(flight.Draw(meets));
            Follow(medium, ref flight, meets, out RgbW part);
            left *= meets.Select(part, Rgb.White);
        }
    }

    private static void Follow(VaryingMedium medium, ref FlightW flight, in MaskW among, out RgbW left)
    {
        left = Rgb.White;
        RgbW share = medium.Share;
        for (MaskW going = flight.Seek(medium, among, aboveBase: true); going.Any; going = flight.Seek(medium, going, aboveBase: true))
        {
            medium.Extinction(flight.Place(), flight.Direction, out RgbW extinction);
            FloatW inverse = 1f / flight.Rate;
            left *= going.Select(
                new RgbW(
                    Kept(extinction.R, share.R * flight.Base, inverse), Kept(extinction.G, share.G * flight.Base, inverse), Kept(extinction.B, share.B * flight.Base, inverse)),
                Rgb.White);
            FloatW most = FloatW.Max(left.R, FloatW.Max(left.G, left.B));
            MaskW asked = going & (most < Little);
            if (asked.Any)
            {
                FloatW chance = most * (1 / Little);
                MaskW survives = flight.Draw(asked) < chance;
                left *= asked.Select(survives.Select(1f / FloatW.Max(chance, float.Epsilon), 0f), 1f);
                going = going.Except(asked.Except(survives));
            }

            flight.Depth = going.Select(FlightW.DepthOf(flight.Draw(going)), flight.Depth);
        }

        left *= MediumTable.Transmittance(share, flight.BaseDepth);
    }

    private static FloatW Kept(in FloatW extinction, in FloatW least, in FloatW inverse) => FloatW.Max(0f, FloatW.Min(1f - ((extinction - least) * inverse), 1f));
}
