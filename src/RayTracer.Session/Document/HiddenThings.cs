using RayTracer.Description;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Session;

/// <summary>Scenes without the things that are hidden.</summary>
internal static class HiddenThings
{
    /// <summary>Leaves things out.</summary>
    /// <param name="read">The scene as it was read, for nobody else: what is known of groups is known of those with less in them, too.</param>
    /// <param name="scene">The scene.</param>
    /// <param name="hidden">The pointers of the things.</param>
    /// <returns>The scene without them.</returns>
    public static SceneDescription Without(SceneReadResult read, SceneDescription scene, IReadOnlyList<string> hidden)
    {
        HashSet<JsonNode> nodes = [.. hidden.Select(p => JsonPointer.Find(read.Root!, p)).OfType<JsonNode>()];
        return scene with { Shapes = Seen(scene.Shapes), Lights = Seen(scene.Lights) };

        IReadOnlyList<ShapeDescription> Seen(IReadOnlyList<ShapeDescription> all) =>
            [.. all.Where(s => read.SourceMap.Find(s) is not { } node || !nodes.Contains(node)).Select(Thinned).OfType<ShapeDescription>()];

        // Null for a group of which nothing is left.
        ShapeDescription? Thinned(ShapeDescription shape)
        {
            if (shape is not GroupDescription group || Seen(group.Shapes) is not { } left || left.Count == group.Shapes.Count && left.Zip(group.Shapes).All(p => ReferenceEquals(p.First, p.Second)))
            {
                return shape;
            }

            GroupDescription thinned = group with { Shapes = left };
            read.SourceMap.Follow(group, thinned);
            return left.Count == 0 ? null : thinned;
        }
    }
}
