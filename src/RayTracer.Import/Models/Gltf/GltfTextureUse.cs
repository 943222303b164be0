using System.Numerics;

namespace RayTracer.Import;

/// <summary>The use of a texture by a material (glTF 2.0, "textureInfo", and KHR_texture_transform).</summary>
/// <param name="Texture">Which of the file's textures.</param>
/// <param name="UvSet">Which set of uv.</param>
/// <param name="Scale">First, factors on uv.</param>
/// <param name="Rotation">Then, an angle in radians.</param>
/// <param name="Offset">Last, what is added.</param>
internal sealed record GltfTextureUse(int Texture, int UvSet, Vector2 Scale, float Rotation, Vector2 Offset)
{
    /// <summary>Reads a property; null where there is none.</summary>
    public static GltfTextureUse? Of(GltfDocument document, GltfObject? owner, string key)
    {
        if (owner?.Child(key) is not { } info)
        {
            return null;
        }

        GltfObject? transform = info.Extension("KHR_texture_transform");
        return new(
            document.RequiredReference(info, "index", "textures"),
            transform?.Integer("texCoord") ?? info.Integer("texCoord") ?? 0,
            Pair(transform, "scale", Vector2.One),
            transform?.Number("rotation", 0) ?? 0,
            Pair(transform, "offset", Vector2.Zero));
    }

    private static Vector2 Pair(GltfObject? from, string key, Vector2 fallback) =>
        from?.Numbers(key, 2) is { } pair ? new(pair[0], pair[1]) : fallback;
}
