using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>The animations of a glTF file (glTF 2.0, section 3.11).</summary>
internal sealed class GltfClips(GltfDocument document, GltfAccessors accessors)
{
    /// <summary>Reads all.</summary>
    /// <exception cref="ModelException">Something is wrong with one.</exception>
    public IReadOnlyList<GltfClip> Read()
    {
        GltfClip[] clips = [.. document.List("animations").Select(Read)];
        document.Notes.AddIf(clips.Length > 1, $"of {clips.Length} animations, the first is played unless \"playback\" names another");
        return clips;
    }

    private GltfClip Read(GltfObject animation)
    {
        GltfClip clip = new(animation.Text("name") ?? "");
        IReadOnlyList<GltfObject> samplers = animation.Children("samplers");
        Dictionary<(int, int), GltfSampler> known = [];
        foreach (GltfObject channel in animation.Children("channels"))
        {
            GltfObject target = channel.RequiredChild("target");
            GltfProperty? property = Property(target);
            int index = channel.RequiredInteger("sampler");
            if (index >= samplers.Count)
            {
                throw channel.Error("sampler", $"there is no sampler {index}: the animation has {samplers.Count}");
            }

            if (property is null || document.Reference(target, "node", "nodes") is not { } node)
            {
                document.Notes.Add("an animation of something else than places, joints and morph targets is ignored");
                continue;
            }

            int components = property switch { GltfProperty.Rotation => 4, GltfProperty.Weights => 1, _ => 3 };
            clip.Channels[(node, property.Value)] = known.Remember((index, components), () => new(accessors, samplers[index], components));
        }

        return clip;
    }

    private static GltfProperty? Property(GltfObject target) => (target.Text("path") ?? throw target.Missing("path")) switch
    {
        "translation" => GltfProperty.Translation,
        "rotation" => GltfProperty.Rotation,
        "scale" => GltfProperty.Scale,
        "weights" => GltfProperty.Weights,
        "pointer" => null,
        var other => throw target.Error("path", $"{Quotation.Of(other)} is not one of translation, rotation, scale, weights"),
    };
}

/// <summary>What an animation changes of a node.</summary>
internal enum GltfProperty
{
    /// <summary>How far it is moved.</summary>
    Translation,

    /// <summary>How it is turned.</summary>
    Rotation,

    /// <summary>Its size along its axes.</summary>
    Scale,

    /// <summary>The weights of its mesh's morph targets.</summary>
    Weights,
}

/// <summary>An animation.</summary>
/// <param name="name">Its name; empty for none.</param>
internal sealed class GltfClip(string name)
{
    /// <summary>The keys of what changes.</summary>
    public Dictionary<(int Node, GltfProperty Property), GltfSampler> Channels { get; } = [];

    /// <summary>It, as models say of it.</summary>
    public ModelAnimation Model => new(name, Channels.Values.Select(s => (double)s.Times[^1]).DefaultIfEmpty(0).Max());
}
