-- | The manual page, made from the help and the table of settings.
module BlackHole.Cli.ManualPage (manualPage) where

import BlackHole.Cli.AnimationHelp
import BlackHole.Cli.Help
import BlackHole.Cli.Topics
import BlackHole.Scene.Field.Field
import BlackHole.Scene.Field.Table (sceneFields)
import BlackHole.Scene.Preset (Preset (..), describedPresets)
import Data.Maybe (fromMaybe)

-- | The manual page in the macros of @man@, given the program's version.
manualPage :: String -> [CommandHelp] -> String
manualPage version commands =
  unlines $
    [ ".TH BLACKHOLE 1 \"\" \"" ++ version ++ "\" \"User Commands\"",
      ".SH NAME",
      "blackhole \\- physically accurate pictures of a black hole",
      ".SH SYNOPSIS",
      ".B blackhole",
      "\\fICOMMAND\\fR [\\fIOPTION\\fR...]",
      ".SH DESCRIPTION",
      roff
        "Traces light backwards from a camera through the curved space around a black hole, \
        \rotating or not: a disk of glowing gas, the sky behind it, and the hole's shadow.",
      roff "Equal scenes give equal bytes for any number of threads.",
      roff
        "Lengths are in Schwarzschild radii (r_s), times in r_s/c, and angles in degrees unless \
        \stated otherwise.",
      roff "If an option is given more than once, the last one counts.",
      ".SH COMMANDS"
    ]
      ++ concatMap commandPart commands
      ++ [ ".SH SCENE FILES",
           roff
             "A scene file is YAML with the settings below, and preset: NAME to start from a \
             \preset. The options of render set the settings named in brackets. blackhole scene \
             \show default prints a complete scene file."
         ]
      ++ concat
        [ (".SS " ++ topicName topic) :
          concat
            [ [".TP", ".B " ++ roff (fieldPath f), roff (pathMeaning f)]
              | f <- sceneFields,
                fieldTopic f == topic
            ]
          | topic <- [minBound ..]
        ]
      ++ [".SH ANIMATION"]
      ++ concatMap part animationHelp
      ++ [".SH PRESETS"]
      ++ concat
        [[".TP", ".B " ++ roff (presetName p), roff (presetShows p)] | p <- describedPresets]
      ++ [".SH EXIT STATUS"]
      ++ concat [[".TP", ".B " ++ code, roff text] | (code, text) <- exitTexts]
      ++ [ ".SH ENVIRONMENT",
           ".TP",
           ".B NO_COLOR",
           "If set and not empty, the output has no colours."
         ]
  where
    commandPart c =
      [ ".SS blackhole " ++ roff (commandName c),
        roff (unwords (words (commandSummary c ++ " " ++ commandDetails c)))
      ]
        ++ concat
          [ (".PP" : [".B " ++ roff title]) ++ concatMap (item c) entries
            | (title, entries) <- sections c
          ]
        ++ concat [[".PP", "Example:", ".PP", ".EX", roff line, ".EE"] | line <- commandExamples c]
    item c e = [".TP", ".B " ++ roff (entryLabel e), roff (entryMeaning c e)]
    pathMeaning f =
      fieldDoc f ++ fromMaybe "" (defaultNote (fieldDoc f) f)
        ++ maybe "" (\o -> " [" ++ optionName o ++ "]") (fieldOption f)
    part p = case p of
      Paragraph text -> [".PP", roff text]
      Verbatim code -> [".PP", ".EX"] ++ map roff code ++ [".EE"]
      Terms terms -> concat [[".TP", ".B " ++ roff term, roff text] | (term, text) <- terms]

roff :: String -> String
roff text = case concatMap escaped text of
  line@(c : _) | c `elem` ".'" -> "\\&" ++ line
  line -> line
  where
    escaped c = case c of
      '\\' -> "\\e"
      '-' -> "\\-"
      _ -> [c]
