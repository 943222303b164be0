using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Reads the numbers of attributes.</summary>
internal static class MitsubaNumbers
{
    /// <summary>The words of a list, between commas and spaces.</summary>
    public static string[] Words(string text) => text.Split([' ', ',', ';', '\t', '\r', '\n'], StringSplitOptions.RemoveEmptyEntries);

    /// <summary>A number; null, after an error, where it is none.</summary>
    public static float? Float(MitsubaElement element, string attribute, ImportLog log) =>
        element.Attribute(attribute) is { } text ? Float(text, element.PlaceOf(attribute), log) : Missing<float>(element, attribute, log);

    /// <summary>A number; null, after an error, where the word is none.</summary>
    public static float? Float(string word, SourcePlace place, ImportLog log)
    {
        if (!float.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out float value) || !float.IsFinite(value))
        {
            return log.Fail<float?>(place, $"expected a number, but found {Quotation.Of(word.Trim())}");
        }

        return value;
    }

    /// <summary>A whole number; null, after an error, where it is none.</summary>
    public static int? Integer(MitsubaElement element, string attribute, ImportLog log)
    {
        if (element.Attribute(attribute) is not { } text)
        {
            return Missing<int>(element, attribute, log);
        }

        if (!int.TryParse(text, NumberStyles.Integer, CultureInfo.InvariantCulture, out int value))
        {
            return log.Fail<int?>(element.PlaceOf(attribute), $"expected a whole number, but found {Quotation.Of(text.Trim())}");
        }

        return value;
    }

    /// <summary>The numbers of a list; null, after an error, where there are too many or too few, or one is none.</summary>
    public static float[]? Floats(MitsubaElement element, string attribute, ImportLog log, params ReadOnlySpan<int> counts)
    {
        if (element.Attribute(attribute) is not { } text)
        {
            Missing<float>(element, attribute, log);
            return null;
        }

        string[] words = Words(text);
        if (!counts.Contains(words.Length))
        {
            return log.Fail<float[]>(element.PlaceOf(attribute), $"expected {string.Join(" or ", counts.ToArray())} numbers for {Quotation.Of(attribute)}, but found {words.Length}");
        }

        float?[] values = [.. words.Select(w => Float(w, element.PlaceOf(attribute), log))];
        return values.Contains(null) ? null : [.. values.Select(v => v!.Value)];
    }

    /// <summary>A vector of the attributes x, y and z, or of <c>value</c> with one or three numbers; null after an error.</summary>
    /// <param name="element">The element.</param>
    /// <param name="standard">The value of coordinates that are not given.</param>
    /// <param name="log">Takes what is wrong.</param>
    public static Vector3? Vector(MitsubaElement element, float standard, ImportLog log)
    {
        if (element.Attributes.ContainsKey("value"))
        {
            if (Floats(element, "value", log, 1, 3) is not { } values)
            {
                return null;
            }

            return values.Length == 1 ? new(values[0]) : new(values[0], values[1], values[2]);
        }

        Vector3 vector = new(standard);
        for (int axis = 0; axis < 3; axis++)
        {
            string name = "xyz".Substring(axis, 1);
            if (element.Attributes.ContainsKey(name))
            {
                if (Float(element, name, log) is not { } value)
                {
                    return null;
                }

                vector[axis] = value;
            }
        }

        return vector;
    }

    private static T? Missing<T>(MitsubaElement element, string attribute, ImportLog log)
        where T : struct
    {
        return log.Fail<T?>(element.Place, $"<{element.Name}> needs the attribute {Quotation.Of(attribute)}");
    }
}
