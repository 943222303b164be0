using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>Undo and redo restore exact texts; a gesture is one step.</summary>
[Trait("Category", "Thorough")]
public sealed class UndoTests
{
    [Fact]
    public void Random_edits_and_gestures_are_undone_and_redone_to_the_character()
    {
        Random random = new(TestSettings.Seed);
        UndoHistory history = new();
        history.Reset(isSaved: true);
        string text = "0123456789";
        List<string> steps = [text];
        string? last = null;
        for (int i = 0; i < TestSettings.Scale(500, 20_000); i++)
        {
            string? gesture = random.Next(3) > 0 ? $"g{i / 7}" : null;
            string after = Edited(text, random);
            if (after == text)
            {
                continue;
            }

            history.Add(TextChange.Between(text, after), text, "edit", gesture);
            text = after;
            if (gesture is not null && gesture == last)
            {
                steps[^1] = text;
            }
            else
            {
                steps.Add(text);
            }

            last = gesture;
        }

        foreach (string expected in steps.AsEnumerable().Reverse().Skip(1))
        {
            text = history.Undo()!.Value.Apply(text);
            Assert.Equal(expected, text);
        }

        Assert.Null(history.Undo());
        Assert.True(history.IsSaved);
        foreach (string expected in steps.Skip(1))
        {
            text = history.Redo()!.Value.Apply(text);
            Assert.Equal(expected, text);
        }

        Assert.Null(history.Redo());
    }

    [Fact]
    public void A_gesture_does_not_go_on_after_undo_or_saving()
    {
        UndoHistory history = new();
        history.Reset(isSaved: true);
        history.Add(new(0, "", "a"), "", "typing", "g");
        history.MarkSaved(history.Seal());
        history.Add(new(1, "", "b"), "a", "typing", "g");
        Assert.False(history.IsSaved);
        Assert.Equal(new TextChange(1, "b", ""), history.Undo());
        Assert.True(history.IsSaved);
        history.Add(new(1, "", "c"), "a", "typing", "g");
        Assert.Equal(new TextChange(1, "c", ""), history.Undo());
        Assert.Equal(new TextChange(0, "a", ""), history.Undo());
    }

    [Fact]
    public void What_was_saved_and_undone_and_edited_over_is_never_saved_again()
    {
        UndoHistory history = new();
        history.Reset(isSaved: true);
        history.Add(new(0, "", "a"), "", "typing", null);
        history.MarkSaved(history.Seal());
        history.Undo();
        history.Add(new(0, "", "b"), "", "typing", null);
        Assert.False(history.IsSaved);
        Assert.Null(history.ToRedo);
    }

    private static string Edited(string text, Random random)
    {
        int from = random.Next(text.Length + 1);
        int to = Math.Min(text.Length, from + random.Next(4));
        return text[..from] + new string((char)('a' + random.Next(3)), random.Next(5)) + text[to..];
    }
}
