using System.Globalization;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Scenes;

/// <summary>Reads numbers, vectors and colours, and checks their ranges.</summary>
internal sealed class NumberReader(DiagnosticBag bag)
{
    public object? Number(RecordParameter parameter, JsonNode node) => Single(parameter.Key, node, parameter);

    public object? Integer(RecordParameter parameter, JsonNode node)
    {
        string key = Quotation.Of(parameter.Key);
        bool isInt = parameter.ValueType == typeof(int);
        return Double(parameter.Key, node) is not { } value ? null
            : Math.Abs(value) > (isInt ? int.MaxValue : 1L << 53) ? TooLarge<object>(node, key, "")
            : value != Math.Floor(value) ? NotWhole<object>(node, key)
            : !IsInRange(parameter.Key, node, value, parameter) ? null
            : isInt ? (int)value : (object)(long)value;
    }

    /// <summary>Reads three whole numbers.</summary>
    public TriangleIndices? Triangle(string key, JsonNode node)
    {
        if (Elements(key, node, 3) is null)
        {
            return null;
        }

        int?[] corners = [.. node.Items.Select(i => WholeNumber(key, i))];
        return corners.Contains(null) ? null : new(corners[0]!.Value, corners[1]!.Value, corners[2]!.Value);
    }

    /// <summary>Reads an element of a list of whole numbers.</summary>
    public int? WholeNumber(string key, JsonNode node) => Double(key, node) is not { } value ? null
        : value != Math.Floor(value) || Math.Abs(value) > int.MaxValue ? NotWhole<int?>(node, Quotation.Of(key))
        : (int)value;

    private double? Double(string key, JsonNode node) => node.Kind != JsonKind.Number ? bag.Expected<double?>(node, "a whole number", key)
        : double.Parse(node.Text, NumberStyles.Float, CultureInfo.InvariantCulture);

    private T? NotWhole<T>(JsonNode node, string key) =>
        bag.Fail<T>(node, $"expected a whole number for {key}, but found {Quotation.Short(node.Text)}", DiagnosticRule.WrongKind);

    private T? TooLarge<T>(JsonNode node, string key, string beyond) =>
        bag.Fail<T>(node, $"{key} is too large: {Quotation.Short(node.Text)}{beyond}", DiagnosticRule.OutOfRange);

    /// <summary>Reads a colour.</summary>
    /// <param name="key">The key whose value is the colour, for messages.</param>
    /// <param name="node">The colour.</param>
    /// <param name="bounds">The parameters whose ranges it must keep to.</param>
    public Rgb? Color(string key, JsonNode node, params ReadOnlySpan<RecordParameter> bounds) => node.Kind switch
    {
        JsonKind.String when CssColors.Find(node.Text) is { } named => named,
        JsonKind.String when node.Text.StartsWith('#') => CssColors.FromHex(node.Text)
            ?? bag.Fail<Rgb?>(node, $"{Quotation.Of(node.Text)} is not a colour: expected # and three or six hexadecimal digits"),
        JsonKind.String => bag.Unknown<Rgb?>(node, $"unknown colour {Quotation.Of(node.Text)}", CssColors.Names),
        JsonKind.Number => Single(key, node, bounds) is { } grey ? new Rgb(grey, grey, grey) : null,
        JsonKind.Array => Elements(key, node, 3, bounds) is { } c ? new Rgb(c[0], c[1], c[2]) : null,
        _ => bag.Expected<Rgb?>(node, "a colour", key),
    };

    /// <summary>Reads so many numbers in brackets.</summary>
    public float[]? Elements(string key, JsonNode node, int count, params ReadOnlySpan<RecordParameter> bounds)
    {
        if (node.Kind != JsonKind.Array)
        {
            return bag.Expected<float[]>(node, $"an array of {count} numbers", key);
        }

        if (node.Items.Count != count)
        {
            return bag.Fail<float[]>(node, $"expected {count} numbers for {Quotation.Of(key)}, but found {node.Items.Count}", DiagnosticRule.WrongKind);
        }

        float[] values = new float[count];
        bool good = true;
        for (int i = 0; i < count; i++)
        {
            float? value = Single(key, node.Items[i], bounds);
            values[i] = value ?? 0;
            good &= value is not null;
        }

        return good ? values : null;
    }

    private float? Single(string key, JsonNode node, params ReadOnlySpan<RecordParameter> bounds)
    {
        if (node.Kind != JsonKind.Number)
        {
            return bag.Expected<float?>(node, "a number", key);
        }

        float value = float.Parse(node.Text, NumberStyles.Float, CultureInfo.InvariantCulture);
        if (!float.IsFinite(value))
        {
            return TooLarge<float?>(node, Quotation.Of(key), " is beyond 3.4e38");
        }

        foreach (RecordParameter parameter in bounds)
        {
            if (!IsInRange(key, node, value, parameter))
            {
                return null;
            }
        }

        return value;
    }

    private bool IsInRange(string key, JsonNode node, double value, RecordParameter bounds)
    {
        string? complaint = bounds.RangeComplaint(value, Quotation.Short(node.Text));
        return complaint is null || bag.Fail<bool>(node, $"{Quotation.Of(key)} {complaint}", DiagnosticRule.OutOfRange);
    }
}
