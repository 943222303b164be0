using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>The coordinates that a texture in space uses.</summary>
public enum TextureSpace
{
    /// <summary>Those in which the shape's own numbers are given: the texture goes with the shape.</summary>
    Object,

    /// <summary>Those of the world: shapes move through the texture.</summary>
    World,
}

/// <summary>Describes a <see cref="SpaceTexture"/>.</summary>
public abstract record SpaceTextureDescription : TextureDescription
{
    /// <summary>The coordinates that are used.</summary>
    [Parameter("Whose coordinates are used: the object's (those of the shape's own numbers, before any transform, so that the texture "
        + "moves with it) or the world's.")]
    public TextureSpace Space { get; init; } = TextureSpace.Object;

    /// <summary>The transform of the texture in these coordinates; empty for the identity.</summary>
    [Parameter("How the texture is moved in these coordinates: steps, the first one applied first. A scale of 2 makes it twice as coarse.")]
    public IReadOnlyList<TransformDescription> Transform { get; init; } = [];

    /// <summary>The coordinates of the texture.</summary>
    internal TexturePlace Place(SceneBuilder builder) => new(Space, TransformSteps.Place(this, Transform, builder));
}

/// <summary>The coordinates that a texture in space uses.</summary>
/// <param name="space">Whose coordinates are used.</param>
/// <param name="transform">The transform of the texture within them.</param>
internal sealed class TexturePlace(TextureSpace space, Transform transform)
{
    private readonly bool _isMoved = !transform.IsIdentity;
    private readonly float[] _back = Rows(transform.Inverse());

    /// <summary>What must be known of points.</summary>
    public TextureInputs Inputs { get; } = space == TextureSpace.World ? TextureInputs.WorldPoint : TextureInputs.ObjectPoint;

    /// <summary>Points in the texture's own coordinates.</summary>
    public void Find(in TexturePointW at, out Vec3W point)
    {
        point = space == TextureSpace.World ? at.World : at.Local;
        if (_isMoved)
        {
            point = new(Row(0, point), Row(4, point), Row(8, point));
        }
    }

    private static float[] Rows(in Transform map) =>
    [
        (float)map.X.A, (float)map.X.B, (float)map.X.C, (float)map.X.D, (float)map.Y.A, (float)map.Y.B, (float)map.Y.C, (float)map.Y.D,
        (float)map.Z.A, (float)map.Z.B, (float)map.Z.C, (float)map.Z.D,
    ];

    private FloatW Row(int i, in Vec3W p) =>
        FloatW.MultiplyAdd(p.X, _back[i], FloatW.MultiplyAdd(p.Y, _back[i + 1], FloatW.MultiplyAdd(p.Z, _back[i + 2], _back[i + 3])));
}

/// <summary>A texture that fills space: what a surface cuts out of a block.</summary>
/// <param name="place">The place of the texture.</param>
/// <param name="first">The texture where its amount is 0.</param>
/// <param name="second">The texture where its amount is 1.</param>
internal abstract class SpaceTexture(TexturePlace place, Texture first, Texture second) : BlendTexture(place.Inputs, first, second)
{
    /// <inheritdoc/>
    protected sealed override void Amount(in TexturePointW at, out FloatW amount)
    {
        place.Find(at, out Vec3W point);
        Amount(point, out amount);
    }

    /// <summary>The weight of the second texture, from 0 to 1.</summary>
    /// <param name="point">The points, in the texture's own coordinates.</param>
    /// <param name="amount">The amount.</param>
    protected abstract void Amount(in Vec3W point, out FloatW amount);
}
