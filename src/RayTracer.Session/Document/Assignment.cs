using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>Gives things a material or a texture that has a name.</summary>
internal static class Assignment
{
    private const int MostNested = 16;

    /// <summary>Makes a thing of a material.</summary>
    /// <param name="text">The text.</param>
    /// <param name="thing">The thing.</param>
    /// <param name="name">The material's name.</param>
    /// <exception cref="SessionException">It is nothing that is made of a material.</exception>
    public static JsonText Material(JsonText text, string thing, string name)
    {
        SceneValue shape = Thing(text, thing);
        return text.Set(JsonPointer.Append(shape.Pointer, "material"), JsonValue.Create(name));
    }

    /// <summary>
    /// Makes a texture the colour of a material, or of that of a thing. A material that other things are made of stays as it is: the thing gets a copy.
    /// </summary>
    /// <param name="text">The text.</param>
    /// <param name="target">The material or the thing.</param>
    /// <param name="name">The texture's name.</param>
    /// <exception cref="SessionException">There is no colour that a texture could be.</exception>
    public static JsonText Texture(JsonText text, string target, string name)
    {
        if (SceneReferences.DefinedAt(target) == SceneTypes.Materials && SceneValue.At(text.Root, target) is { Node: not null } definition)
        {
            return Colored(text, definition, name, 0);
        }

        SceneValue shape = Thing(text, target);
        SceneValue material = shape.Child("material")!;
        if (material.Reference is { } shared && SceneReferences.To(text.Root, SceneTypes.Materials, shared).Skip(1).Any())
        {
            (text, string copy) = SceneThings.Duplicate(text, JsonPointer.Of("materials", shared));
            text = text.Set(material.Pointer, JsonValue.Create(JsonPointer.Last(copy)));
        }

        return Colored(text, SceneValue.At(text.Root, material.Pointer)!, name, 0);
    }

    private static SceneValue Thing(JsonText text, string pointer) =>
        SceneValue.At(text.Root, pointer) is { Node: not null, Type: { IsLight: false } type } shape && shape.Family == SceneTypes.Shapes && type.Find("material") is not null
            ? shape : throw new SessionException("That is nothing that is made of a material.");

    private static JsonText Colored(JsonText text, SceneValue material, string name, int nesting)
    {
        if (material.Node is null)
        {
            return text.Set(material.Pointer, new JsonObject { ["type"] = "diffuse", ["color"] = name });
        }

        SceneValue made = material.Resolved(text.Root);
        SceneValue? mainly = nesting > MostNested ? null : Outline.MainKeys.Select(made.Child).FirstOrDefault(c => c is not null);
        return mainly switch
        {
            null => throw new SessionException($"A material of type {made.Type?.Name ?? "unknown"} has no colour that a texture could be."),
            { Family.Noun: "material" } => Colored(text, mainly, name, nesting + 1),
            _ => text.Set(mainly.Pointer, JsonValue.Create(name)),
        };
    }
}
