using System.Globalization;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Reads what stands behind the directives of a file: names, parameters and numbers.</summary>
/// <param name="text">The words of the file.</param>
/// <param name="directives">The words that begin a directive.</param>
/// <param name="log">Takes what is wrong.</param>
internal sealed class PbrtArguments(PbrtText text, IReadOnlyCollection<string> directives, ImportLog log)
{
    /// <summary>The words of the file.</summary>
    public PbrtText Text => text;

    /// <summary>Passes over what follows an unknown word, up to the next directive.</summary>
    public void Skip()
    {
        while (text.Peek() is { } next && (next.IsQuoted || !directives.Contains(next.Text)))
        {
            text.Next();
        }
    }

    /// <summary>The name that a directive needs; null, after an error, where there is none.</summary>
    public PbrtToken? Name(PbrtToken directive)
    {
        if (text.Peek() is { IsQuoted: true })
        {
            return text.Next();
        }

        log.Error(text.Peek()?.Place ?? text.Place, $"{directive.Text} needs a name in quotation marks, but found {(text.Peek() is { } other ? Quotation.Of(other.Text) : "the end of the file")}");
        Skip();
        return null;
    }

    /// <summary>The next parameter; null where there is none.</summary>
    public PbrtParameter? Parameter()
    {
        while (text.Peek() is { IsQuoted: true } declaration)
        {
            text.Next();
            if (new PbrtValues(log).Read(declaration, text) is { } parameter)
            {
                return parameter;
            }
        }

        return null;
    }

    /// <summary>So many numbers, which may stand in brackets; null, after an error, where there are not.</summary>
    public float[]? Numbers(PbrtToken directive, int count)
    {
        bool isBracketed = text.Peek()?.Is("[") == true;
        if (isBracketed)
        {
            text.Next();
        }

        float[] numbers = new float[count];
        for (int i = 0; i < count; i++)
        {
            if (text.Peek() is not { IsQuoted: false } word || !float.TryParse(word.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i]) || !float.IsFinite(numbers[i]))
            {
                string found = text.Peek() is { } other ? Quotation.Of(other.Text) : "the end of the file";
                log.Error(text.Peek()?.Place ?? text.Place, $"{directive.Text} needs {count} numbers, but after {i} of them there is {found}");
                Skip();
                return null;
            }

            text.Next();
        }

        if (isBracketed && text.Peek()?.Is("]") == true)
        {
            text.Next();
        }
        else if (isBracketed)
        {
            log.Error(text.Peek()?.Place ?? text.Place, $"expected ] after the {count} numbers of {directive.Text}");
            Skip();
        }

        return numbers;
    }
}
