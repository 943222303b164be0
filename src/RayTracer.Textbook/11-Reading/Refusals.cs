using RayTracer.Description;

namespace RayTracer.Textbook;

/// <summary>What a scene asks for that this edition lacks, each with its record and parameter: nothing is left out in silence.</summary>
internal sealed class Refusals
{
    // What changes no light: for editors, for pictures of it, or for lists.
    private static readonly string[] s_harmless =
        ["Name", "LightGroup", "ToneMap", "Exposure", "FramesPerSecond", "Animation", "Splitting", "SphereLightSampling", "Textures", "Materials", "Objects"];

    private readonly List<SceneComplaint> _complaints = [];

    /// <summary>All of them.</summary>
    public IReadOnlyList<SceneComplaint> All => _complaints;

    /// <summary>Refuses a whole record by the name of its type.</summary>
    /// <param name="record">The record.</param>
    /// <param name="kind">What it is one of: "shape", "material" …</param>
    /// <param name="known">The types that there are.</param>
    /// <returns>Null, in the place of what there is not.</returns>
    public object? Type(object record, string kind, string known) =>
        Say(record, null, $"the textbook edition has no {kind} of type \"{RecordType.Of(record.GetType()).Name}\": it has {known}");

    /// <summary>Refuses something about a parameter.</summary>
    public object? Say(object record, string? property, string message)
    {
        if (!_complaints.Exists(c => ReferenceEquals(c.Subject, record) && c.Property == property))
        {
            _complaints.Add(new(record, property, message, IsError: true));
        }

        return null;
    }

    /// <summary>Refuses the parameters of a record that are given, except for those that are understood.</summary>
    /// <param name="record">The record.</param>
    /// <param name="understood">The names of their C# properties.</param>
    public void Rest(object record, params string[] understood)
    {
        RecordType type = RecordType.Of(record.GetType());
        foreach (RecordParameter parameter in type.Parameters.Where(p => !understood.Contains(p.PropertyName) && !s_harmless.Contains(p.PropertyName)))
        {
            object? value = parameter.Get(record);
            if (value is System.Collections.ICollection list ? list.Count > 0 : !Equals(value, parameter.Default))
            {
                Say(record, parameter.PropertyName, $"the textbook edition has no \"{parameter.Key}\" of a {type.Name}");
            }
        }
    }
}
