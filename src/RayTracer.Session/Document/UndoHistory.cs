namespace RayTracer.Session;

/// <summary>All changes of a text since it was opened, without limit. Those of one gesture are one step. Not thread-safe.</summary>
public sealed class UndoHistory
{
    private readonly List<UndoStep> _steps = [];
    private int _done;
    private int _saved;
    private bool _isSealed = true;

    /// <summary>Returns whether the text is as it was when it was saved last.</summary>
    public bool IsSaved => _done == _saved;

    /// <summary>The step that <see cref="Undo"/> takes back; null where there is none.</summary>
    public UndoStep? ToUndo => _done > 0 ? _steps[_done - 1] : null;

    /// <summary>The step that <see cref="Redo"/> does again; null where there is none.</summary>
    public UndoStep? ToRedo => _done < _steps.Count ? _steps[_done] : null;

    /// <summary>Takes a change that has been made. What had been undone cannot be done again after it.</summary>
    /// <param name="change">The change.</param>
    /// <param name="before">The text before it.</param>
    /// <param name="label">The change, in a word or two.</param>
    /// <param name="gesture">The gesture that it is a part of; null where it stands alone.</param>
    public void Add(TextChange change, string before, string label, string? gesture)
    {
        _steps.RemoveRange(_done, _steps.Count - _done);
        _saved = _saved > _done ? -1 : _saved;
        if (!_isSealed && gesture is not null && _done > 0 && _steps[_done - 1] is { } last && last.Gesture == gesture)
        {
            _steps[_done - 1] = last with { Change = last.Change.Then(change, before), Label = label };
            return;
        }

        _steps.Add(new(change, label, gesture));
        _done++;
        _isSealed = false;
    }

    /// <summary>Takes the last step back.</summary>
    /// <returns>The change to make; null where there is none.</returns>
    public TextChange? Undo()
    {
        _isSealed = true;
        return _done == 0 ? null : _steps[--_done].Change.Inverse;
    }

    /// <summary>Does the step again that was undone last.</summary>
    /// <returns>The change to make; null where there is none.</returns>
    public TextChange? Redo()
    {
        _isSealed = true;
        return _done == _steps.Count ? null : _steps[_done++].Change;
    }

    /// <summary>Ends the last step, so that nothing is joined to it any more.</summary>
    /// <returns>The point in the history, for <see cref="MarkSaved"/>.</returns>
    public int Seal()
    {
        _isSealed = true;
        return _done;
    }

    /// <summary>Records that the text of a point in the history has been saved.</summary>
    /// <param name="point">The point, as <see cref="Seal"/> gave it, if it is still in the history.</param>
    public void MarkSaved(int point) => _saved = point;

    /// <summary>Forgets everything.</summary>
    /// <param name="isSaved">True if the text is that of a file.</param>
    public void Reset(bool isSaved)
    {
        _steps.Clear();
        _done = 0;
        _saved = isSaved ? 0 : -1;
        _isSealed = true;
    }
}

/// <summary>The step that one press of undo reverts.</summary>
/// <param name="Change">The change of the text.</param>
/// <param name="Label">The change, in a word or two.</param>
/// <param name="Gesture">The drag or the burst of typing that it came from; null where it stands alone.</param>
public sealed record UndoStep(TextChange Change, string Label, string? Gesture);
