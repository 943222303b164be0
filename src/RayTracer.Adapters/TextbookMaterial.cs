using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textbook;

namespace RayTracer.Adapters;

/// <summary>
/// Describes a material whose class is the textbook edition's <see cref="IMaterial"/>. It renders in both editions: in the fast one lane by lane, at
/// the speed of its class.
/// </summary>
public abstract record TextbookMaterialDescription : MaterialDescription, IOwnMaterial
{
    /// <summary>Why the material is not reciprocal; null where it is.</summary>
    public virtual string? ReciprocityException => null;

    /// <inheritdoc/>
    public abstract IMaterial Make(TextureMaker texture);

    /// <inheritdoc/>
    public sealed override Material Build(SceneBuilder builder) => new TextbookMaterial(Make(TexturesOf(this, builder)), ReciprocityException);

    /// <summary>What makes the textures of a record, of those of the fast edition.</summary>
    /// <param name="record">The record.</param>
    /// <param name="builder">Makes them, and takes diagnostics.</param>
    internal static TextureMaker TexturesOf(object record, SceneBuilder builder) => (description, isNumber) =>
    {
        Textures.Texture texture = isNumber ? builder.NumberTexture(description) : builder.Texture(description);
        if ((texture.Inputs & Textures.TextureInputs.BeyondUv) != Textures.TextureInputs.None)
        {
            builder.Error(record, null, "a material of the textbook edition sees its textures by u and v: not noise, marble, wood or the colours of vertices");
        }

        return new LaneTexture(texture);
    };
}

/// <summary>A material of the textbook edition in the fast one: asked for each lane by itself.</summary>
/// <param name="material">The material.</param>
/// <param name="reciprocityException">Why it is not reciprocal; null where it is.</param>
internal sealed unsafe class TextbookMaterial(IMaterial material, string? reciprocityException) : Material
{
    private delegate Textbook.Rgb Answer(in Hit hit, Vector from, Vector to);

    /// <summary>All that it may do: what of that it does, only its answers say.</summary>
    public override MaterialTraits Traits { get; } = new()
    {
        IsLit = true,
        Transmits = true,
        UsesUv = true,
        UsesDistance = true,
        Specular = SpecularLobe.Glossy,
        ReciprocityException = reciprocityException,
    };

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response) =>
        Ask(surface, surface.Facing, (in hit, from, _) => material.Ambient(hit, from), out response);

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo)
    {
        Ask(surface, surface.Facing, Share, out albedo);

        // Who does not care for ambient light may say nothing of it.
        Textbook.Rgb Share(in Hit hit, Vector from, Vector to) => material.Ambient(hit, from) is { IsBlack: false } ambient ? ambient : material.Matt(hit, from) * Math.PI;
    }

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf) => Ask(surface, surface.Facing, (in hit, from, _) => material.Matt(hit, from), out brdf);

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf) =>
        Ask(surface, direction, (in hit, from, to) => material.Evaluate(hit, from, to), out bsdf);

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        Ask(surface, direction, (in hit, from, to) => new(material.Pdf(hit, from, to)), out RgbW all);
        pdf = all.R;
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        FloatW choice = samples.Choice();
        Lanes lanes = new(stackalloc float[Lanes.Floats]);
        (uint glossy, uint delta, uint absorbed) = (0, 0, 0);
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            Hit hit = HitOf(surface, lane);
            Vector from = hit.Frame.ToLocal(-Lanes.Vector(surface.Incoming, lane));
            if (material.Sample(hit, from, new LaneSampler(u[lane], v[lane], choice[lane])) is not { } s)
            {
                absorbed |= 1u << lane;
                lanes.Set(lane, hit.Frame.ToWorld(from), default);
                continue;
            }

            glossy |= s.Lobe == Lobe.Matt ? 0 : 1u << lane;
            delta |= s.Lobe == Lobe.Mirror ? 1u << lane : 0;
            lanes.Set(lane, hit.Frame.ToWorld(s.Direction), surface.CarriesLight ? s.ParticleWeight : s.Weight);
        }

        scatter = new()
        {
            Direction = lanes.Direction,
            Weight = lanes.Color,
            Specular = Lanes.Mask(glossy),
            Delta = Lanes.Mask(delta),
            Absorbed = Lanes.Mask(absorbed),
        };
    }

    private static void Ask(in SurfaceW surface, in Vec3W direction, Answer answer, out RgbW color)
    {
        Lanes lanes = new(stackalloc float[Lanes.Floats]);
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            Hit hit = HitOf(surface, lane);
            Vector from = hit.Frame.ToLocal(-Lanes.Vector(surface.Incoming, lane));
            lanes.Set(lane, default, answer(hit, from, hit.Frame.ToLocal(Lanes.Vector(direction, lane))));
        }

        color = lanes.Color;
    }

    private static Hit HitOf(in SurfaceW surface, int lane)
    {
        Vector facing = Lanes.Vector(surface.Facing, lane).Unit;
        bool isInside = (surface.Inside.Bits >> lane & 1) != 0;
        return new()
        {
            Distance = surface.Distance[lane],
            Point = Lanes.Vector(surface.Point, lane),
            Normal = Lanes.Vector(surface.Normal, lane),
            Shading = isInside ? -facing : facing,
            U = surface.U[lane],
            V = surface.V[lane],
            Inside = isInside,
            Frame = new(facing),
        };
    }
}
