using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The scene file's text, and what is wrong with it.</summary>
internal sealed class SourceViewModel(SessionDispatcher dispatcher) : Observable
{
    private readonly Gesture _typing = new();
    private string _text = "";
    private string _base = "";
    private int _revision = -1;
    private bool _isSending;
    private DocumentSnapshot? _unseen;

    /// <summary>The text. What is typed goes to the session at once.</summary>
    public string Text
    {
        get => _text;
        set
        {
            if (SetProperty(ref _text, value ?? ""))
            {
                Sending.Push(_text);
            }
        }
    }

    public IReadOnlyList<ProblemViewModel> Problems { get; private set; } = [];

    /// <summary>The number of problems, in words.</summary>
    public string Summary => Problems.Count switch
    {
        0 => SessionTexts.Of("editor.fine"),
        1 => SessionTexts.Of("editor.one"),
        _ => SessionTexts.Of("editor.count", Problems.Count),
    };

    public bool HasProblems => Problems.Count > 0;

    /// <summary>The chosen problem: the editor goes to its place.</summary>
    public ProblemViewModel? Chosen
    {
        get;
        set
        {
            if (SetProperty(ref field, value) && value is not null)
            {
                Place = new(value.From, value.To);
            }
        }
    }

    /// <summary>The part of the text that the editor shall show, selected.</summary>
    public TextPlace Place { get; set => SetProperty(ref field, value); } = new(0, 0);

    private Latest<string> Sending => field ??= new(Send);

    /// <summary>Shows a document's text.</summary>
    public void Show(DocumentSnapshot shown)
    {
        // While something is on its way, it is unknown whether the session has it already.
        if (_isSending)
        {
            _unseen = shown;
            return;
        }

        if (shown.Revision <= _revision)
        {
            return;
        }

        // What was typed and is not with the session yet is put into the session's text.
        TextStretch? typed = TextStretch.Between(_base, _text);
        TextStretch? theirs = TextStretch.Between(_base, shown.Text);
        (_base, _revision) = (shown.Text, shown.Revision);
        string merged = typed?.After(theirs)?.Apply(_base) ?? _base;
        if (merged != _text)
        {
            _text = merged;
            OnPropertyChanged(nameof(Text));
        }
    }

    /// <summary>Shows what is wrong.</summary>
    public void Show(DocumentStatus status)
    {
        ProblemViewModel[] problems = [.. status.Diagnostics.Select(d => new ProblemViewModel(d.Line, d.Column, d.From, d.To, d.Severity == "error", d.Message))];
        if (!problems.SequenceEqual(Problems))
        {
            Problems = problems;
            Report(nameof(Problems), nameof(Summary), nameof(HasProblems));
        }
    }

    private async Task Send(string text)
    {
        if (TextStretch.Between(_base, _text) is not { } change)
        {
            return;
        }

        (int revision, string sent, string gesture) = (_revision, _text, _typing.Burst());
        _isSending = true;
        await dispatcher.Attempt(async () =>
        {
            if (await dispatcher.Ask(s => s.Document.TryReplace(revision, change.From, change.To, change.Insert, gesture)))
            {
                (_base, _revision) = (sent, revision + 1);
            }
            else
            {
                // Somebody else was quicker.
                _unseen = await dispatcher.Ask(DocumentSnapshot.Of);
            }
        });
        _isSending = false;
        if (_unseen is { } unseen)
        {
            _unseen = null;
            Show(unseen);
        }

        if (_text != _base && _revision != revision)
        {
            Sending.Push(_text);
        }
    }
}

/// <summary>A part of a text.</summary>
/// <param name="From">Offset of its first character.</param>
/// <param name="To">Offset behind its last character.</param>
internal sealed record TextPlace(int From, int To);

/// <summary>Something that is wrong with the text.</summary>
internal sealed record ProblemViewModel(int Line, int Column, int From, int To, bool IsError, string Message)
{
    /// <summary>The line and column in words; empty where it is about no place.</summary>
    public string Where => Line > 0 ? SessionTexts.Of("editor.at", Line, Column) : "";
}

/// <summary>The one stretch in which two texts differ.</summary>
/// <param name="From">Offset of the first character that goes.</param>
/// <param name="To">Offset behind the last one.</param>
/// <param name="Insert">The text that replaces them.</param>
internal sealed record TextStretch(int From, int To, string Insert)
{
    /// <summary>The stretch between two texts; null where they are the same.</summary>
    public static TextStretch? Between(string before, string after)
    {
        if (before == after)
        {
            return null;
        }

        int start = before.AsSpan().CommonPrefixLength(after);
        int end = 0;
        while (end < Math.Min(before.Length, after.Length) - start && before[^(end + 1)] == after[^(end + 1)])
        {
            end++;
        }

        return new(start, before.Length - end, after[start..^end]);
    }

    /// <summary>The text after the change.</summary>
    public string Apply(string text) => $"{text.AsSpan(0, From)}{Insert}{text.AsSpan(To)}";

    /// <summary>The same change after another one of the same text; null where both are about the same characters.</summary>
    public TextStretch? After(TextStretch? other)
    {
        int shift = other is null ? 0 : other.Insert.Length - (other.To - other.From);
        return other is null || other.From >= To ? this
            : other.To <= From ? this with { From = From + shift, To = To + shift }
            : null;
    }
}
